#include "renderer/scene/text_lines.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola {

std::string read_text_file(const std::filesystem::path& path, std::size_t largest) {
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(path, unknown); !unknown && size > largest) {
    throw Error(path.string(), fmt::format("has {} bytes; up to {} are read", size, largest));
  }
  std::string text = read_file(path);
  if (text.find('\0') != std::string::npos) {
    throw Error(path.string(), "is not a text file");
  }
  return text;
}

void blank_byte_order_mark(std::string& text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) {
    text.replace(0, mark.size(), mark.size(), ' ');
  }
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

Statement statement_in(std::string_view line) {
  const std::string_view text = trimmed(line);
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  return {.keyword = text.substr(0, end), .rest = trimmed(text.substr(end))};
}

}  // namespace foveola
