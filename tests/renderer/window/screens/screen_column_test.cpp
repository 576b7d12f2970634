#include "renderer/window/screens/screen_column.h"

#include <limits>

#include "renderer/base/text/utf8.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

/// A typewriter's letters, of 10 pixels each.
float typed_width(std::string_view line) {
  return 10.0F * static_cast<float>(count_characters(line));
}

TEST(WrappedText, BreaksBetweenWords) {
  EXPECT_THAT(wrap_to_width("one two three", 90.0F, typed_width), ElementsAre("one two", "three"));
  EXPECT_THAT(wrap_to_width("one two three", 130.0F, typed_width), ElementsAre("one two three"));
}

TEST(WrappedText, KeepsLineBreaks) {
  EXPECT_THAT(wrap_to_width("one\ntwo\n\nthree", 900.0F, typed_width),
              ElementsAre("one", "two", "", "three"));
}

TEST(WrappedText, BreaksAWordThatIsTooLongByItself) {
  EXPECT_THAT(wrap_to_width("a übergroß b", 40.0F, typed_width),
              ElementsAre("a", "über", "groß", "b"));
}

TEST(WrappedText, EndsWhereNoLetterFits) {
  for (const float width_px : {9.0F, 0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THAT(wrap_to_width("xyz ü", width_px, typed_width), ElementsAre("x", "y", "z", "ü"))
        << width_px;
  }
  EXPECT_THAT(wrap_to_width("", -1.0F, typed_width), ElementsAre(""));
}

TEST(WrappedText, NothingIsALine) {
  EXPECT_THAT(wrap_to_width("", 40.0F, typed_width), ElementsAre(""));
}

TEST(WrappedText, KeepsSpacesThatAreTyped) {
  EXPECT_THAT(wrap_to_width("a  b ", 90.0F, typed_width), ElementsAre("a  b "));
}

TEST(WrappedText, NoLineIsLongerThanIsGoodToRead) {
  const auto lines = wrap_to_width(
      std::string(30, 'x') + ' ' + std::string(39, 'y') + " z " + std::string(71, 'w'), 1e6F,
      typed_width);
  EXPECT_THAT(lines, ElementsAre(std::string(30, 'x') + ' ' + std::string(39, 'y'), "z",
                                 std::string(70, 'w'), "w"));
}

TEST(WrappedText, FindsTheWidestWord) {
  EXPECT_EQ(widest_word_px("one\nthree four", typed_width), 50.0F);
}

}  // namespace
}  // namespace foveola
