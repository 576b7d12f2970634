// Opens encoded images, which come from strangers, once their headers have been found sensible.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace foveola {

enum class ImageFormats : std::uint8_t {
  texture,      ///< PNG and JPEG, which glTF has
  environment,  ///< those, EXR and HDR
};

/// An image whose pixels have not been read yet.
struct OpenImage {
  std::unique_ptr<OIIO::Filesystem::IOProxy> memory;  ///< read by `input`, so it dies after it
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;
};

/// Opens an image of one of the formats, told by its first bytes; alpha will not be premultiplied.
/// `encoded` must outlive the result. Throws std::runtime_error that says what is wrong if it is of
/// another format, cut off or damaged, not flat, larger than 16384 pixels on a side, or announces
/// more pixels than so many bytes can hold.
OpenImage open_image(std::span<const unsigned char> encoded, ImageFormats allowed);

}  // namespace foveola
