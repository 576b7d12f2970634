#include "renderer/base/text/utf8.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace foveola {
namespace {

std::string text_of(std::initializer_list<char32_t> characters) {
  std::string text;
  for (const char32_t character : characters) {
    append_character(text, character);
  }
  return text;
}

// The bytes are RFC 3629's examples (section 7) and the ends of its ranges (section 3).
TEST(Utf8Test, AppendsCharactersAsTheStandardEncodesThem) {
  EXPECT_EQ(text_of({0x41, 0x2262, 0x0391, 0x2E}), "\x41\xE2\x89\xA2\xCE\x91\x2E");
  EXPECT_EQ(text_of({0xD55C, 0xAD6D, 0xC5B4}), "\xED\x95\x9C\xEA\xB5\xAD\xEC\x96\xB4");
  EXPECT_EQ(text_of({0x233B4}), "\xF0\xA3\x8E\xB4");
  EXPECT_EQ(text_of({0x7F, 0x80, 0x7FF, 0x800}), "\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80");
  EXPECT_EQ(text_of({0xFFFF, 0x10000, 0x10FFFF}), "\xEF\xBF\xBF\xF0\x90\x80\x80\xF4\x8F\xBF\xBF");
}

TEST(Utf8Test, WhatIsNoCharacterIsLeftOut) {
  EXPECT_EQ(text_of({0xD800, 0xDFFF, 0x110000, 0xFFFFFFFF}), "");
}

TEST(Utf8Test, ErasesWholeCharacters) {
  std::string text = "aä€𝄞";
  for (const char* left : {"aä€", "aä", "a", "", ""}) {
    erase_last_character(text);
    EXPECT_EQ(text, left);
  }
}

TEST(Utf8Test, CountsCharacters) {
  EXPECT_EQ(count_characters(""), 0U);
  EXPECT_EQ(count_characters("aä€𝄞"), 4U);
}

TEST(Utf8Test, ControlCharactersAreNotPrintable) {
  EXPECT_EQ(printable("Küche 2 — 台所 𝄞\u00A0\u00BF"), "Küche 2 — 台所 𝄞\u00A0\u00BF");
  EXPECT_EQ(printable(std::string_view("a\x1b[2J\0b\n\tc\x7f", 11)), "a?[2J?b  c?");
  EXPECT_EQ(printable("\u0080a\u009B31mb\u009F"), "?a?31mb?");
  EXPECT_EQ(printable("\xC2"), "\xC2");
  EXPECT_EQ(printable("a\x9B"
                      "1m\xC0\x9B"),
            "a?1m?")
      << "C1 as a byte, ESC in overlong form";
}

// The bidirectional controls of Unicode's annex 9, section 2, its other marks of direction, and the
// characters of category Cf without width in U+200B to U+2064 and U+FEFF.
TEST(Utf8Test, CharactersThatTurnTheTextOrCannotBeSeenAreNotPrintable) {
  for (const char32_t hidden :
       {0x061C, 0x200B, 0x200C, 0x200D, 0x200E, 0x200F, 0x2028, 0x2029, 0x202A, 0x202B,
        0x202C, 0x202D, 0x202E, 0x2060, 0x2064, 0x2066, 0x2067, 0x2068, 0x2069, 0xFEFF}) {
    EXPECT_EQ(printable(text_of({U'a', hidden, U'b'})), "a?b") << std::hex << std::uint32_t{hidden};
  }
  for (const char32_t seen : {0x00A0, 0x061B, 0x061D, 0x200A, 0x2010, 0x2027, 0x202F, 0x205F,
                              0x2070, 0xFEFE, 0xFF00, 0x1F600}) {
    EXPECT_EQ(printable(text_of({seen})), text_of({seen})) << std::hex << std::uint32_t{seen};
  }
}

TEST(Utf8Test, EscapesStandAsInJson) {
  EXPECT_EQ(escaped("a\x1b[2J\r\x7f\u009b\u202eb\tc\nd \u00e4 \u53f0"),
            "a\\u001b[2J\\u000d\\u007f\\u009b\\u202eb\tc\nd \u00e4 \u53f0");
}

TEST(Utf8Test, CountsTheBytesOfTheFirstCharacters) {
  const std::string text = "aä€𝄞";
  EXPECT_EQ(bytes_of_first(text, 0), 0U);
  EXPECT_EQ(bytes_of_first(text, 1), 1U);
  EXPECT_EQ(bytes_of_first(text, 2), 3U);
  EXPECT_EQ(bytes_of_first(text, 3), 6U);
  EXPECT_EQ(bytes_of_first(text, 4), 10U);
  EXPECT_EQ(bytes_of_first(text, 9), 10U);
}

TEST(Utf8Test, ABeginningEndsWithItsLineOrItsCharacters) {
  EXPECT_EQ(beginning_of("the phone rang", 20), "the phone rang");
  EXPECT_EQ(beginning_of("the phone rang", 9), "the phone …");
  EXPECT_EQ(beginning_of("aä€𝄞", 2), "aä …");
  EXPECT_EQ(beginning_of("a\x1b[2J\nb", 20), "a?[2J …");
  EXPECT_EQ(beginning_of("", 3), "");
}

}  // namespace
}  // namespace foveola
