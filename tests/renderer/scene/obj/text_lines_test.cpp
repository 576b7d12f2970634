#include "renderer/scene/obj/text_lines.h"

#include "renderer/base/error.h"
#include "tests/error_of.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

std::string fault_of(const std::string& bytes) {
  return error_of([&] { utf8_text("a.obj", bytes); });
}

TEST(Utf8Text, KeepsUtf8AndBlanksItsByteOrderMark) {
  EXPECT_EQ(utf8_text("a.obj", "v 1\n"), "v 1\n");
  EXPECT_EQ(utf8_text("a.obj", "\xEF\xBB\xBFv 1\n"), "   v 1\n");
}

/// "a", e with an acute accent (U+00E9), the euro sign (U+20AC) and a chair (U+1FA91).
TEST(Utf8Text, ReadsUtf16OfEitherOrder) {
  const std::string utf8 = "a\xC3\xA9\xE2\x82\xAC\xF0\x9F\xAA\x91";
  const std::string little("\xFF\xFE\x61\0\xE9\0\xAC\x20\x3E\xD8\x91\xDE", 12);
  const std::string big("\xFE\xFF\0\x61\0\xE9\x20\xAC\xD8\x3E\xDE\x91", 12);
  EXPECT_EQ(utf8_text("a.obj", little), utf8);
  EXPECT_EQ(utf8_text("a.obj", big), utf8);
  EXPECT_EQ(utf8_text("a.obj", "\xFF\xFE\x3E\xD8"), "\xEF\xBF\xBD") << "half a character";
}

TEST(Utf8Text, RefusesWhatIsNoText) {
  EXPECT_THAT(fault_of(std::string("v\0 1", 4)), HasSubstr("a.obj: is not a text file"));
  EXPECT_THAT(fault_of("\xFF\xFE\x61"), HasSubstr("a.obj: is UTF-16 text that is cut off"));
  EXPECT_THAT(fault_of(std::string("\xFF\xFE\0\0", 4)), HasSubstr("is not a text file"));
}

}  // namespace
}  // namespace foveola::test
