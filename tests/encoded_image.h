// Image files of all kinds, made for tests by OpenImageIO. It is loaded with the first of them,
// since most tests need none.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace foveola::test {

struct EncodableSamples {
  std::string format;  ///< OpenImageIO's name of it: "png"
  int width = 0;
  int height = 0;
  int channels = 0;
  /// Interleaved, row by row from the top.
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> samples;
  std::vector<std::string> channel_names{};  ///< none: OpenImageIO's
  int tile_side = 0;                         ///< 0: without tiles
};

/// The bytes of the file, in which alpha is not premultiplied. Throws std::runtime_error that says
/// what went wrong.
std::string encoded_image(const EncodableSamples& image);

}  // namespace foveola::test
