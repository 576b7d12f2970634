// The one place that decides which numbers of an image file are its colours, and in which colour
// space they are.
#pragma once

#include "renderer/image/image.h"
#include "renderer/image/image_codec.h"

namespace foveola {

/// The picture in linear Rec. 709: integers are sRGB, floats are linear, in the primaries that the
/// file states (Rec. 709 unless it does), white staying white. It is of the channels R, G and B; of
/// the layer Combined, which is Blender's picture, where there are none; or of the only layer with
/// R, G and B. One or two channels are a grey, and what follows it. Alpha is left out. Throws
/// std::runtime_error that names the channels if there is no such layer or more than one.
RgbImage read_linear_color(ImageReader& image);

}  // namespace foveola
