// Image files by OpenImageIO, which brings some 250 shared libraries along: they are loaded when
// the first image is read or written, so that whatever needs no image starts without them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
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
  bool is_flat = true;  ///< neither a volume nor with several values to a pixel and channel
  bool has_bytes = false;
  bool has_floats = false;     ///< 16 or 32 bits; if neither, integers of more than 8 bits
  std::size_t tile_bytes = 0;  ///< size of a tile, which is read as a whole; 0 without tiles
};

/// An image whose pixels have not been read yet.
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
  /// Any image that OpenImageIO knows.
  std::unique_ptr<ImageReader> (*open_file)(const std::string& path);
  /// format: OpenImageIO's name of it. `encoded` must outlive the reader, which does not
  /// premultiply alpha, and whose faults begin with "is damaged: ".
  std::unique_ptr<ImageReader> (*open_bytes)(std::span<const unsigned char> encoded,
                                             const std::string& format);
  /// In the format of the path's extension.
  void (*write_file)(const std::string& path, const EncodableImage& image);
};

/// Loads OpenImageIO at the first call; from any thread. Throws Error if that fails.
const ImageCodec& image_codec();

}  // namespace foveola
