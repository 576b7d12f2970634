#include "renderer/scene/sanitised.h"

#include <algorithm>

namespace foveola {

std::string sanitised(std::string_view text) {
  constexpr std::size_t longest = 120;
  std::size_t size = std::min(text.size(), longest);
  const auto is_inside_character = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
  };
  while (size > 0 && size < text.size() && is_inside_character(size)) {
    --size;
  }
  std::string result(text.substr(0, size));
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return result;
}

}  // namespace foveola
