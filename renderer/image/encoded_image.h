// Opens encoded images, which are untrusted, after validating their headers.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "renderer/image/image_codec.h"

namespace foveola {

enum class ImageFormats : std::uint8_t {
  gltf_texture,  ///< PNG, JPEG and WebP
  any_texture,   ///< and BMP, GIF, TGA and TIFF
  environment,   ///< all of these, EXR, HDR and PNM
  picture,       ///< the same, of more pixels on a side
};

/// Opens an image of one of the formats, recognised by its first bytes. `encoded` must outlive the
/// result. Throws std::runtime_error that names the fault if the image has another format, is
/// truncated, damaged or not flat, or is larger than 16384 pixels on a side (a picture: 65536).
/// Throws too if it announces more pixels than its bytes can hold. A WebP image may compress
/// without bound and is decoded on opening: its maximum is 2^26 pixels.
std::unique_ptr<ImageReader> open_image(std::span<const unsigned char> encoded,
                                        ImageFormats allowed);

}  // namespace foveola
