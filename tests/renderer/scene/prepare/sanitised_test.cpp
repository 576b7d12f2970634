#include "renderer/scene/prepare/sanitised.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(Sanitised, ReplacesControlCharacters) {
  EXPECT_EQ(sanitised("Fenêtre 2 (ö)"), "Fenêtre 2 (ö)");
  EXPECT_EQ(sanitised(std::string_view("a\x1b[2J\0b\nc\x7f", 10)), "a?[2J?b c?");
}

TEST(Sanitised, IsNeverLong) {
  EXPECT_EQ(sanitised(std::string(1000, 'x')), std::string(120, 'x'));
}

TEST(Sanitised, IsNotCutInsideACharacter) {
  EXPECT_EQ(sanitised(std::string(119, 'x') + "ö!"), std::string(119, 'x'));
  EXPECT_EQ(sanitised(std::string(118, 'x') + "ö!"), std::string(118, 'x') + "ö");
}

}  // namespace
}  // namespace foveola
