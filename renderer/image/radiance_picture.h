// Decodes Radiance pictures (.hdr) with their headers; OpenImageIO reads only the pixels.
#pragma once

#include <memory>
#include <span>

#include "renderer/image/image_codec.h"

namespace foveola {

/// Reads radiance in watts per steradian and square metre: pixels divided by all EXPOSURE and
/// COLORCORR lines, RGBE or XYZE, with the stated PRIMARIES. The first row is at the top and the
/// first column at the left for any scanline order ("File Formats", Radiance 1997). `encoded` must
/// outlive the result. Throws std::runtime_error that names the fault.
std::unique_ptr<ImageReader> open_radiance_picture(std::span<const unsigned char> encoded);

}  // namespace foveola
