// Radiance pictures (.hdr) as their headers say: OpenImageIO reads the pixels alone.
#pragma once

#include <memory>
#include <span>

#include "renderer/image/image_codec.h"

namespace foveola {

/// Reads the picture in watts per steradian and square metre: divided by all EXPOSURE and COLORCORR
/// lines, first row at the top and first column at the left, whichever way its scanlines run, RGBE
/// or XYZE, with the PRIMARIES that it states ("File Formats", Radiance 1997). `encoded` must
/// outlive it. Throws std::runtime_error that says what is wrong.
std::unique_ptr<ImageReader> open_radiance_picture(std::span<const unsigned char> encoded);

}  // namespace foveola
