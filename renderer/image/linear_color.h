// Decides which channels of an image file are its colours, and their colour space.
#pragma once

#include "renderer/image/image.h"
#include "renderer/image/image_codec.h"

namespace foveola {

/// Reads the picture in linear Rec. 709. Integers are sRGB; floats are linear in the file's
/// primaries (default Rec. 709), with white kept white. Uses the channels R, G and B, else the
/// layer Combined (Blender's picture), else the only layer with R, G and B. One or two channels are
/// grey and alpha; alpha is left out. Throws std::runtime_error that names the channels if no such
/// layer is unique.
RgbImage read_linear_color(ImageReader& image);

/// Whether the primaries that the file states, if any, span a colour space. Others are ignored.
bool has_valid_primaries(const ImageHeader& header);

}  // namespace foveola
