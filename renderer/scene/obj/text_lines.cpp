#include "renderer/scene/obj/text_lines.h"

#include <cstdint>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

namespace foveola {
namespace {

/// Removes the digits at the front of `text`, and returns their number.
std::size_t take_digits(std::string_view& text) {
  const auto* const end =
      std::ranges::find_if_not(text, [](char c) { return c >= '0' && c <= '9'; });
  const auto count = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(count);
  return count;
}

/// Removes one of `characters` from the front of `text`, if it begins with one.
bool take(std::string_view characters, std::string_view& text) {
  const bool is_there = !text.empty() && characters.find(text.front()) != std::string_view::npos;
  text.remove_prefix(is_there ? 1 : 0);
  return is_there;
}

void append_utf8(std::uint32_t code_point, std::string& text) {
  const auto last = [&](unsigned shift) {
    return static_cast<char>(0x80U | (code_point >> shift & 0x3FU));
  };
  if (code_point < 0x80) {
    text += static_cast<char>(code_point);
  } else if (code_point < 0x800) {
    text += {static_cast<char>(0xC0U | code_point >> 6U), last(0)};
  } else if (code_point < 0x10000) {
    text += {static_cast<char>(0xE0U | code_point >> 12U), last(6), last(0)};
  } else {
    text += {static_cast<char>(0xF0U | code_point >> 18U), last(12), last(6), last(0)};
  }
}

/// bytes: UTF-16 after its byte order mark, of an even number; low: index of a unit's lower byte, 0
/// or 1. An unpaired surrogate becomes the replacement character.
std::string utf8_from_utf16(std::string_view bytes, std::size_t low) {
  constexpr std::uint32_t replacement = 0xFFFD;
  const auto unit = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + low])) |
           static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + 1 - low])) << 8U;
  };
  const auto is_surrogate = [](std::uint32_t value, std::uint32_t first) {
    return value >= first && value < first + 0x400U;
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const std::uint32_t high = unit(i);
    const std::uint32_t next = i + 2 < bytes.size() ? unit(i + 2) : 0;
    if (is_surrogate(high, 0xD800) && is_surrogate(next, 0xDC00)) {
      append_utf8(0x10000 + ((high - 0xD800) << 10U) + (next - 0xDC00), text);
      i += 2;
    } else {
      append_utf8(high >= 0xD800 && high < 0xE000 ? replacement : high, text);
    }
  }
  return text;
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path, std::size_t largest) {
  std::error_code unknown;
  if (const auto size = std::filesystem::file_size(path, unknown); !unknown && size > largest) {
    throw Error(path.string(), fmt::format("has {} bytes; up to {} are read", size, largest));
  }
  return read_file(path);
}

std::string utf8_text(const std::filesystem::path& path, std::string bytes) {
  constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
  const bool is_little_endian = bytes.starts_with("\xFF\xFE");
  if (is_little_endian || bytes.starts_with("\xFE\xFF")) {
    if (bytes.size() % 2 != 0) {
      throw Error(path.string(), "is UTF-16 text that is cut off", "export it again");
    }
    bytes = utf8_from_utf16(std::string_view(bytes).substr(2), is_little_endian ? 0 : 1);
  } else if (bytes.starts_with(utf8_mark)) {
    bytes.replace(0, utf8_mark.size(), utf8_mark.size(), ' ');
  }
  if (bytes.find('\0') != std::string::npos) {
    throw Error(path.string(), "is not a text file");
  }
  return bytes;
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
  constexpr std::size_t longest_exponent = 9;  // tinyobjloader rejects longer ones
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
