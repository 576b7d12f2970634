#include "renderer/window/screens/screen_fonts.h"

#include <imgui.h>

#include "tests/matchers.h"
#include "tests/renderer/window/screen_capture.h"
#include "tests/renderer/window/screen_letters.h"

namespace foveola {
namespace {

constexpr const char* japanese = "同意しますか？";  // what the test package's font has
constexpr char32_t no_character = 0xFDD0;           // by Unicode: never to be one

bool has_japanese_font() { return characters_without_font(japanese).empty(); }

TEST(LetterFonts, KnowsTheCharactersOfAText) {
  EXPECT_THAT(characters_of("aé\nあ𝄞a"), ElementsAre(U'a', U'é', U'あ', U'𝄞'));
  EXPECT_THAT(characters_of(""), IsEmpty());
}

TEST(LetterFonts, APageIsReadWhole) {
  const ScreenPage page{
      .title = "a",
      .paragraphs = {"b", "c"},
      .fields = {{.question = "d", .labels = {"e"}, .typed = "f", .note = "i", .fault = "g"}},
      .keys = "h"};
  EXPECT_EQ(characters_of(page), characters_of("abcdefghi"));
}

TEST(LetterFonts, WhatNoFontHasIsNamed) {
  EXPECT_THAT(characters_without_font("Zoë \xEF\xB7\x90 Ωж"), ElementsAre(no_character));
  EXPECT_THAT(fonts_for({no_character}), IsEmpty());
  EXPECT_THAT(characters_without_font("𝄞"), ElementsAre(U'𝄞')) << "beyond U+FFFF";
}

TEST(ScreenFontsTest, DejaVuHasMoreThanEuropesLetters) {
  const Characters georgian = characters_of("გამარჯობა");
  const test::ScreenLetters letters(20.0F, georgian);
  const test::ScreenLetters plain(20.0F);
  for (const char32_t letter : georgian) {
    const auto glyph = static_cast<ImWchar>(letter);
    EXPECT_NE(letters.fonts().face(TextFace::body)->FindGlyphNoFallback(glyph), nullptr);
    EXPECT_NE(letters.fonts().face(TextFace::title)->FindGlyphNoFallback(glyph), nullptr);
    EXPECT_EQ(plain.fonts().face(TextFace::body)->FindGlyphNoFallback(glyph), nullptr);
  }
}

TEST(ScreenFontsTest, OtherFontsLettersAreAdded) {
  if (!has_japanese_font()) {
    GTEST_SKIP() << "no font with Japanese letters is installed";
  }
  const test::ScreenLetters letters(20.0F, characters_of(japanese));
  for (const TextFace face : {TextFace::body, TextFace::title}) {
    const ImFont* font = letters.fonts().face(face);
    for (const char32_t letter : characters_of(japanese)) {
      const ImFontGlyph* glyph = font->FindGlyphNoFallback(static_cast<ImWchar>(letter));
      ASSERT_NE(glyph, nullptr) << static_cast<std::uint32_t>(letter);
      EXPECT_GT(glyph->X1, glyph->X0);
    }
    EXPECT_NE(font->FindGlyphNoFallback('a'), nullptr);
    EXPECT_EQ(font->FindGlyphNoFallback(u'猫'), nullptr) << "what nobody asked for costs nothing";
  }
}

TEST(ScreenFontsTest, OnlyNewCharactersAreNews) {
  ScreenFonts fonts;
  EXPECT_FALSE(fonts.add_characters(characters_of("Zoë")));
  EXPECT_TRUE(fonts.add_characters(characters_of("გა")));
  EXPECT_FALSE(fonts.add_characters(characters_of("აZ")));
  EXPECT_TRUE(fonts.add_characters({no_character}));
  EXPECT_FALSE(fonts.add_characters({no_character}));
}

TEST(ScreenFontsTest, APageInJapaneseIsDrawn) {
  if (!has_japanese_font()) {
    GTEST_SKIP() << "no font with Japanese letters is installed";
  }
  test::ScreenCapture screens(test::window_cases[0]);
  const RgbImage written = screens.capture(ScreenPage{.title = japanese});
  const RgbImage other = screens.capture(ScreenPage{.title = "意同しますか？"});
  test::keep_for_people("japanese", written);
  EXPECT_NE(written.pixels, other.pixels) << "the same mark stands for both letters";
}

}  // namespace
}  // namespace foveola
