#include "renderer/scene/text_lines.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola {
namespace {

/// Takes the digits at the front off `text`, and returns how many there were.
std::size_t take_digits(std::string_view& text) {
  const auto* const end =
      std::find_if_not(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  const auto count = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(count);
  return count;
}

/// Takes one of `characters` off the front of `text`, if it begins with one.
bool take(std::string_view characters, std::string_view& text) {
  const bool is_there = !text.empty() && characters.find(text.front()) != std::string_view::npos;
  text.remove_prefix(is_there ? 1 : 0);
  return is_there;
}

}  // namespace

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

bool is_number(std::string_view word) {
  constexpr std::size_t longest_exponent = 9;  // tinyobjloader gives up on longer ones
  take("+-", word);
  std::size_t digits = take_digits(word);
  if (take(".", word)) {
    digits += take_digits(word);
  }
  if (digits > 0 && take("eE", word)) {
    take("+-", word);
    digits = take_digits(word);
    if (digits > longest_exponent) {
      return false;
    }
  }
  return digits > 0 && word.empty();
}

}  // namespace foveola
