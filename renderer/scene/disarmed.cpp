#include "renderer/scene/disarmed.h"

#include <algorithm>

namespace foveola {

std::string disarmed(std::string_view text) {
  constexpr std::size_t longest = 120;
  std::string result(text.substr(0, std::min(text.size(), longest)));
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return result;
}

}  // namespace foveola
