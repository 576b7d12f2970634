// Reads and writes image files by OpenImageIO. Its some 250 shared libraries are loaded on first
// use, so that other work starts without them.
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

/// The unchecked header of an untrusted image file.
struct ImageHeader {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::string> channel_names;
  bool is_flat = true;      ///< neither a volume nor with several values per pixel and channel
  bool has_bytes = false;   ///< 8 bits
  bool has_floats = false;  ///< 16 or 32 bits, linear; integers are sRGB
  /// Number of pixels stored: those of an EXR's data window if it differs from the picture's.
  std::size_t stored_pixels = 0;
  /// Size of a unit of decoding, a tile or such a data window; 0 for neither.
  std::size_t block_bytes = 0;
  /// CIE x and y of red, green, blue and white, if the file states them.
  std::optional<std::array<float, 8>> chromaticities;
  bool is_xyz = false;  ///< the channels are CIE X, Y and Z
};

/// An image whose pixels have not been read yet. Colours are not multiplied by alpha; those of an
/// EXR, which are radiances, stay unchanged.
class ImageReader {
 public:
  ImageReader() = default;
  ImageReader(const ImageReader&) = delete;
  ImageReader& operator=(const ImageReader&) = delete;
  virtual ~ImageReader() = default;

  virtual const ImageHeader& header() const = 0;
  /// Reads all channels, interleaved, row by row from the top, as 8 bits. Throws std::runtime_error
  /// that names the fault.
  virtual void read_bytes(std::uint8_t* values) = 0;
  /// Reads `count` channels from `first` on of each pixel to every `stride`-th float. Throws as
  /// read_bytes.
  virtual void read_floats(int first, int count, float* values, std::size_t stride) = 0;
};

/// An image to encode, row by row from the top: bytes are sRGB.
struct EncodableImage {
  int width = 0;
  int height = 0;
  std::vector<std::string> channel_names;
  std::vector<std::pair<std::string, std::string>> attributes;  ///< for the file's header
  std::span<const std::uint8_t> bytes;  ///< interleaved; empty if there are floats
  std::span<const float> floats;
};

/// All functions throw std::runtime_error that names the fault.
struct ImageCodec {
  /// format: OpenImageIO's name. `encoded` must outlive the reader, whose faults begin with "is
  /// damaged: ". is_stopped: polled while pixels are read; once true, the remaining pixels may stay
  /// unwritten.
  std::unique_ptr<ImageReader> (*open_bytes)(std::span<const unsigned char> encoded,
                                             const std::string& format, bool (*is_stopped)());
  /// The encoded file; format as in open_bytes.
  std::vector<unsigned char> (*encode)(const EncodableImage& image, const std::string& format);
};

/// Loads OpenImageIO at the first call. Throws Error if that fails. May be called from any thread.
const ImageCodec& image_codec();

}  // namespace foveola
