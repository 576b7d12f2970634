// Image files by OpenImageIO, which brings some 250 shared libraries along: they are loaded when
// the first image is read or written, so that whatever needs no image starts without them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace foveola {

/// What the header of an image file says. Files are untrusted: nothing of it has been checked.
struct ImageHeader {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::string> channel_names;
  bool is_flat = true;      ///< neither a volume nor with several values to a pixel and channel
  bool has_bytes = false;   ///< 8 bits
  bool has_floats = false;  ///< 16 or 32 bits, linear; integers, of 8 bits or more, are sRGB
  /// Pixels that the file holds: of an EXR's data window, where that is not the picture's.
  std::size_t stored_pixels = 0;
  /// Size of what is decoded as a whole: a tile, or such a data window; 0 for neither.
  std::size_t block_bytes = 0;
  /// CIE x and y of red, green, blue and white, if the file states them.
  std::optional<std::array<float, 8>> chromaticities;
  bool is_xyz = false;  ///< the channels are CIE X, Y and Z
};

/// An image whose pixels have not been read yet. Colours are not multiplied by alpha, but those of
/// an EXR are as they are, since they are radiance.
class ImageReader {
 public:
  ImageReader() = default;
  ImageReader(const ImageReader&) = delete;
  ImageReader& operator=(const ImageReader&) = delete;
  virtual ~ImageReader() = default;

  virtual const ImageHeader& header() const = 0;
  /// Reads all channels, interleaved, row by row from the top, as 8 bits. Throws
  /// std::runtime_error that says what is wrong.
  virtual void read_bytes(std::uint8_t* values) = 0;
  /// Reads `count` channels from `first` on of each pixel to every `stride`-th float. Throws as
  /// read_bytes.
  virtual void read_floats(int first, int count, float* values, std::size_t stride) = 0;
};

/// What to write, row by row from the top: bytes are sRGB.
struct EncodableImage {
  int width = 0;
  int height = 0;
  std::vector<std::string> channel_names;
  std::vector<std::pair<std::string, std::string>> attributes;  ///< for the file's header
  std::span<const std::uint8_t> bytes;  ///< interleaved; empty if there are floats
  std::span<const float> floats;
};

/// All functions throw std::runtime_error that says what is wrong.
struct ImageCodec {
  /// format: OpenImageIO's name of it. `encoded` must outlive the reader, whose faults begin with
  /// "is damaged: ". is_stopped: asked while pixels are read; once it is true, the rest of them may
  /// stay as it was.
  std::unique_ptr<ImageReader> (*open_bytes)(std::span<const unsigned char> encoded,
                                             const std::string& format, bool (*is_stopped)());
  /// The bytes of a file; format: as of open_bytes.
  std::vector<unsigned char> (*encode)(const EncodableImage& image, const std::string& format);
};

/// Loads OpenImageIO at the first call; from any thread. Throws Error if that fails.
const ImageCodec& image_codec();

}  // namespace foveola
