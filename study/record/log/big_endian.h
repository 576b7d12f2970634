// Numbers as SQLite's files have them, the highest byte first.
#pragma once

#include <cstdint>
#include <string_view>

namespace foveola::study {

/// That of `size` bytes from `offset` on, which `bytes` has.
inline std::uintmax_t big_endian(std::string_view bytes, std::size_t offset, std::size_t size = 4) {
  std::uintmax_t number = 0;
  for (const char byte : bytes.substr(offset, size)) {
    number = number << 8 | static_cast<unsigned char>(byte);
  }
  return number;
}

}  // namespace foveola::study
