#include "renderer/base/utf8.h"

#include <algorithm>

namespace foveola {
namespace {

/// Whether a byte goes on with the character that the bytes before it began.
bool goes_on(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

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
      std::count_if(text.begin(), text.end(), [](char byte) { return !goes_on(byte); }));
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const unsigned char next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    const bool begins_upper_control = byte == 0xC2 && next >= 0x80 && next < 0xA0;
    const bool is_control = byte < 0x20 || byte == 0x7F || begins_upper_control;
    const bool is_space = byte == '\n' || byte == '\r' || byte == '\t';
    result += is_space ? ' ' : is_control ? '?' : text[i];
    i += begins_upper_control ? 1 : 0;
  }
  return result;
}

std::size_t bytes_of_first(std::string_view text, std::size_t characters) {
  const auto end = std::find_if(text.begin(), text.end(), [&](char byte) {
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
