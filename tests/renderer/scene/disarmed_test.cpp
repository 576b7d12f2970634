#include "renderer/scene/disarmed.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(Disarmed, KeepsPrintableText) { EXPECT_EQ(disarmed("Fenêtre 2 (ö)"), "Fenêtre 2 (ö)"); }

TEST(Disarmed, DisarmsControlCharacters) {
  EXPECT_EQ(disarmed(std::string_view("a\x1b[2J\0b\nc\x7f", 10)), "a?[2J?b?c?");
}

TEST(Disarmed, IsNeverLong) { EXPECT_EQ(disarmed(std::string(1000, 'x')), std::string(120, 'x')); }

TEST(Disarmed, IsNotCutInsideACharacter) {
  EXPECT_EQ(disarmed(std::string(119, 'x') + "ö!"), std::string(119, 'x'));
  EXPECT_EQ(disarmed(std::string(118, 'x') + "ö!"), std::string(118, 'x') + "ö");
}

}  // namespace
}  // namespace foveola
