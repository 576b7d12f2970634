#include "renderer/scene/prepare/sanitised.h"

#include <algorithm>

#include "renderer/base/text/utf8.h"

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
  return printable(text.substr(0, size));
}

}  // namespace foveola
