#include "renderer/base/error.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(ErrorTest, IsOneLine) {
  EXPECT_STREQ(Error("a.toml:1:2", "is wrong", "mend it").what(), "a.toml:1:2: is wrong; mend it");
  EXPECT_STREQ(Error("a", "b\nc\r\n\td").what(), "a: b c   d");
}

TEST(ErrorTest, DoesNotControlTheTerminal) {
  EXPECT_STREQ(Error("\x1b]0;x\x07y", "\u009B2J", "Küche").what(), "?]0;x?y: ?2J; Küche");
}

}  // namespace
}  // namespace foveola
