// Opens encoded images, which are untrusted, once their headers have been found sensible.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "renderer/image/image_codec.h"

namespace foveola {

enum class ImageFormats : std::uint8_t {
  gltf_texture,  ///< PNG, JPEG and WebP
  any_texture,   ///< those, BMP, GIF, TGA and TIFF
  environment,   ///< PNG, JPEG, EXR and HDR
  picture,       ///< all of these, and PNM
};

/// Opens an image of one of the formats, recognised by its first bytes. `encoded` must outlive the
/// result. Throws std::runtime_error that says what is wrong if it is of another format, cut off or
/// damaged, not flat, larger than 16384 pixels on a side (a picture: 65536), or announces more
/// pixels than so many bytes can hold; of a WebP image, which can be of one colour in a few bytes,
/// more than 2^26, since OpenImageIO decodes it when it opens it.
std::unique_ptr<ImageReader> open_image(std::span<const unsigned char> encoded,
                                        ImageFormats allowed);

}  // namespace foveola
