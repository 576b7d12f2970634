// Bytes as a person can compare them.
#pragma once

#include <string>

namespace foveola::study {

/// hex: two digits a byte.
inline std::string bytes_from_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes.push_back(static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

}  // namespace foveola::study
