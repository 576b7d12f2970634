#include "renderer/scene/obj/numbers.h"

#include <cstddef>
#include <string_view>
#include <vector>

#include "renderer/scene/obj/text_lines.h"

namespace foveola {
namespace {

std::size_t coordinates_of(std::string_view keyword) {
  return keyword == "v" || keyword == "vn" ? 3 : keyword == "vt" ? 2 : 0;
}

/// The coordinates in the statements of `text` that are no numbers.
std::vector<std::string_view> no_numbers_in(std::string_view text) {
  std::vector<std::string_view> found;
  for_each_line(text, [&](std::string_view line) {
    Statement left = statement_in(line);
    for (std::size_t i = coordinates_of(left.keyword); i > 0; --i) {
      left = statement_in(left.rest);
      if (left.keyword.empty() || left.keyword.front() == '#') {
        break;
      }
      if (!is_number(left.keyword)) {
        found.push_back(left.keyword);
      }
    }
  });
  return found;
}

}  // namespace

std::string with_infinities_for_no_numbers(std::string text) {
  const std::vector<std::string_view> no_numbers = no_numbers_in(text);
  if (no_numbers.empty()) {
    return text;
  }
  std::string result;
  std::size_t copied = 0;
  for (const std::string_view word : no_numbers) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    result.append(text, copied, begin - copied).append("1e999");
    copied = begin + word.size();
  }
  return result.append(text, copied);
}

}  // namespace foveola
