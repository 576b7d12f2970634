#include "renderer/image/webp_alpha.h"

#include <cstddef>
#include <string_view>

namespace foveola {

std::vector<unsigned char> without_webp_alpha(std::span<const unsigned char> encoded) {
  constexpr std::size_t first_chunk = 12;
  constexpr std::size_t chunk_header = 8;
  constexpr std::size_t size_of_flags = 5;
  constexpr unsigned char has_alpha = 0x10;
  std::vector<unsigned char> bytes(encoded.begin(), encoded.end());
  std::size_t at = first_chunk;
  while (at + chunk_header + size_of_flags <= bytes.size()) {
    unsigned char* const chunk = bytes.data() + at;
    const std::string_view kind(reinterpret_cast<const char*>(chunk), 4);
    const std::size_t size = std::size_t{chunk[4]} | std::size_t{chunk[5]} << 8 |
                             std::size_t{chunk[6]} << 16 | std::size_t{chunk[7]} << 24;
    unsigned char* const content = chunk + chunk_header;
    if (kind == "VP8X") {
      content[0] &= static_cast<unsigned char>(~has_alpha);
    } else if (kind == "VP8L") {
      content[4] &= static_cast<unsigned char>(~has_alpha);
    } else if (kind == "ALPH") {
      chunk[0] = 'X';  // decoders pass over chunks that they do not know
    }
    at += chunk_header + size + size % 2;
  }
  return bytes;
}

}  // namespace foveola
