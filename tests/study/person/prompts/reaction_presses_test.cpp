#include "study/person/prompts/reaction_presses.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// It appears after a second, always.
const ReactionSettings a_second{.presses = 2, .shortest_wait_s = 1.0, .longest_wait_s = 1.0};

class ReactionPressesTest : public ::testing::Test {
 protected:
  /// A frame that is drawn and shown at once.
  std::optional<ReactionPressed> show(Nanoseconds time) {
    presses_.begin_frame(time);
    look_ = presses_.look();
    return presses_.end_frame(a_second, time);
  }

  ReactionPresses presses_{Pcg32(1)};
  ReactionLook look_ = ReactionLook::waiting;  ///< in the last frame
};

TEST_F(ReactionPressesTest, TheWaitBeginsWithTheFirstFrame) {
  EXPECT_FALSE(show(10s));
  show(10900ms);
  EXPECT_EQ(look_, ReactionLook::waiting);
  show(11s);
  EXPECT_EQ(look_, ReactionLook::appeared);
}

TEST_F(ReactionPressesTest, APressAtWhatAppearedIsTimedFromItsFrame) {
  show(0s);
  show(1020ms);
  presses_.press(1300ms);
  const auto pressed = show(1310ms);
  ASSERT_TRUE(pressed);
  EXPECT_EQ(pressed->shown, 1020ms);
  EXPECT_EQ(pressed->time, 1300ms);
  EXPECT_FALSE(show(1320ms)) << "reported once";
}

TEST_F(ReactionPressesTest, AnEarlyPressIsSaidSoOnceItIsKept) {
  show(0s);
  presses_.press(300ms);
  const auto pressed = show(310ms);
  ASSERT_TRUE(pressed);
  EXPECT_LT(pressed->time, pressed->shown);
  EXPECT_EQ(presses_.look(), ReactionLook::waiting);
  presses_.was_kept(*pressed);
  presses_.ask();
  EXPECT_TRUE(presses_.was_early());
  show(400ms);
  EXPECT_EQ(look_, ReactionLook::waiting_again);
  show(1450ms);
  EXPECT_EQ(look_, ReactionLook::appeared) << "a second after it was asked again";
}

TEST_F(ReactionPressesTest, AfterAGoodPressItWaitsAsBefore) {
  presses_.was_kept({.shown = 1s, .time = 900ms});
  presses_.was_kept({.shown = 1s, .time = 1200ms});
  EXPECT_FALSE(presses_.was_early());
  EXPECT_EQ(presses_.look(), ReactionLook::waiting);
}

TEST_F(ReactionPressesTest, AskingAnewForgetsTheWaitThatWas) {
  show(0s);
  presses_.ask();  // there was a pause
  show(1500ms);
  EXPECT_EQ(look_, ReactionLook::waiting);
  show(2500ms);
  EXPECT_EQ(look_, ReactionLook::appeared);
}

}  // namespace
}  // namespace foveola::study
