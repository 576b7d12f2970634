#include "renderer/base/text/similar_word.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

TEST(EditDistance, CountsLettersPutInLeftOutReplacedAndExchanged) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("render", "render"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("rendr", "render"), 1U);
  EXPECT_EQ(edit_distance("rennder", "render"), 1U);
  EXPECT_EQ(edit_distance("rander", "render"), 1U);
  EXPECT_EQ(edit_distance("rendre", "render"), 1U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

/// The two forms of the distance differ here: 2 where letters may be edited twice.
TEST(EditDistance, EditsNoLetterTwice) { EXPECT_EQ(edit_distance("ca", "abc"), 3U); }

TEST(SimilarWord, IsTheNearest) {
  EXPECT_EQ(similar_word("churhc", {"arcade", "chunch", "church"}), "church");
  EXPECT_EQ(similar_word("arcade", {"arcades", "arcade"}), "arcade");
  EXPECT_EQ(similar_word("--expozurre", {"--exposure"}), "--exposure");
}

TEST(SimilarWord, IsTheFirstOfEquallyNearOnes) {
  EXPECT_EQ(similar_word("chart", {"charm", "chard"}), "charm");
}

TEST(SimilarWord, TakesAtMostTwoEdits) {
  EXPECT_EQ(similar_word("meeeting-romm", {"meeting-room"}), "meeting-room");
  EXPECT_EQ(similar_word("meeeting-rommm", {"meeting-room"}), std::nullopt);
}

TEST(SimilarWord, TakesAtMostAThirdOfTheLetters) {
  EXPECT_EQ(similar_word("vq", {"vp"}), std::nullopt);
  EXPECT_EQ(similar_word("odd", {"odp"}), "odp");
  EXPECT_EQ(similar_word("abcde", {"abxye"}), std::nullopt);
  EXPECT_EQ(similar_word("abcdef", {"abxyef"}), "abxyef");
}

TEST(SimilarWord, IsNoneOfNothing) {
  EXPECT_EQ(similar_word("", {"", "a"}), "");
  EXPECT_EQ(similar_word("arcade", {}), std::nullopt);
}

}  // namespace
}  // namespace foveola
