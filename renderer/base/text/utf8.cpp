#include "renderer/base/text/utf8.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

namespace foveola {
namespace {

/// Whether a byte continues a character.
bool goes_on(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// A byte that is not UTF-8 counts as itself, as in Latin-1. Overlong forms are decoded as by
/// lenient terminals.
Character first_character(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t bytes = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  char32_t code = bytes == 1 ? lead : lead & 0x7FU >> bytes;
  for (std::size_t i = 1; i < bytes; ++i) {
    if (i >= text.size() || !goes_on(text[i])) {
      return {.code = lead, .bytes = 1};
    }
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  return {.code = code, .bytes = bytes};
}

struct CharacterRange {
  char32_t first;
  char32_t last;
};

/// Characters that a terminal obeys instead of showing (Unicode 15, categories Cc, Cf, Zl and Zp).
constexpr std::array obeyed{
    CharacterRange{0x0000, 0x001F},  // C0
    CharacterRange{0x007F, 0x009F},  // DEL and C1
    CharacterRange{0x061C, 0x061C},  // the Arabic letter mark
    CharacterRange{0x200B, 0x200F},  // without width; marks of direction
    CharacterRange{0x2028, 0x202E},  // separators of lines; embeddings and overrides of direction
    CharacterRange{0x2060, 0x206F},  // joiners; isolates of direction
    CharacterRange{0xFEFF, 0xFEFF},  // the byte order mark
};

bool is_obeyed(char32_t code) {
  return std::ranges::any_of(obeyed, [code](const CharacterRange& range) {
    return code >= range.first && code <= range.last;
  });
}

char as_byte(char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); }

}  // namespace

void append_character(std::string& text, char32_t character) {
  const bool is_surrogate = character >= 0xD800 && character <= 0xDFFF;
  if (is_surrogate || character > 0x10FFFF) {
    return;
  }
  const auto lower_bits = [&](int from) { return as_byte(0x80 | (character >> from & 0x3F)); };
  if (character < 0x80) {
    text += as_byte(character);
  } else if (character < 0x800) {
    text += as_byte(0xC0 | character >> 6);
    text += lower_bits(0);
  } else if (character < 0x10000) {
    text += as_byte(0xE0 | character >> 12);
    text += lower_bits(6);
    text += lower_bits(0);
  } else {
    text += as_byte(0xF0 | character >> 18);
    text += lower_bits(12);
    text += lower_bits(6);
    text += lower_bits(0);
  }
}

void erase_last_character(std::string& text) {
  while (!text.empty() && goes_on(text.back())) {
    text.pop_back();
  }
  if (!text.empty()) {
    text.pop_back();
  }
}

std::size_t count_characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return !goes_on(byte); }));
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (Character next; !text.empty(); text.remove_prefix(next.bytes)) {
    next = first_character(text);
    const bool is_space = next.code == '\n' || next.code == '\r' || next.code == '\t';
    if (is_space || is_obeyed(next.code)) {
      result += is_space ? ' ' : '?';
    } else {
      result += text.substr(0, next.bytes);
    }
  }
  return result;
}

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (Character next; !text.empty(); text.remove_prefix(next.bytes)) {
    next = first_character(text);
    const bool is_layout = next.code == '\n' || next.code == '\t';
    if (is_obeyed(next.code) && !is_layout) {
      result += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(next.code));
    } else {
      result += text.substr(0, next.bytes);
    }
  }
  return result;
}

std::size_t bytes_of_first(std::string_view text, std::size_t characters) {
  const auto end = std::ranges::find_if(text, [&](char byte) {
    if (goes_on(byte)) {
      return false;
    }
    return characters-- == 0;
  });
  return static_cast<std::size_t>(end - text.begin());
}

std::string beginning_of(std::string_view text, std::size_t characters) {
  const std::size_t end = std::min(text.find('\n'), bytes_of_first(text, characters));
  return printable(text.substr(0, end)) + (end < text.size() ? " …" : "");
}

}  // namespace foveola
