#include "study/driver/reaction_test.h"

#include <set>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

/// It appears after exactly two seconds.
constexpr ReactionSettings two_seconds{.presses = 1, .shortest_wait_s = 2.0, .longest_wait_s = 2.0};

class ReactionTestTest : public ::testing::Test {
 protected:
  Pcg32 random_{1};
  ReactionTest test_{two_seconds, 10s, random_};
};

TEST_F(ReactionTestTest, AppearsAfterItsWait) {
  EXPECT_FALSE(test_.appears_at(12s - 1ns));
  EXPECT_TRUE(test_.appears_at(12s));
}

TEST_F(ReactionTestTest, APressHasBothTimes) {
  test_.was_shown(12016ms);
  test_.was_shown(12033ms);  // another frame of it
  EXPECT_FALSE(test_.result());
  test_.was_pressed(12300ms);
  test_.was_pressed(12400ms);
  ASSERT_TRUE(test_.result());
  EXPECT_EQ(test_.result()->shown, 12016ms);
  EXPECT_EQ(test_.result()->time, 12300ms);
}

TEST_F(ReactionTestTest, APressBeforeItIsDueIsAFalseStart) {
  test_.was_pressed(11s);
  ASSERT_TRUE(test_.result());
  EXPECT_EQ(test_.result()->shown, 12s);
  EXPECT_EQ(test_.result()->time, 11s);
}

TEST_F(ReactionTestTest, APressWhileItIsOnItsWayWaitsForIt) {
  test_.was_pressed(12005ms);
  EXPECT_FALSE(test_.result());
  test_.was_shown(12016ms);
  ASSERT_TRUE(test_.result());
  EXPECT_LT(test_.result()->time, test_.result()->shown);
}

TEST_F(ReactionTestTest, NobodyCanGuessTheWait) {
  // 200 waits between 1 and 3 seconds: the chance that a tenth of the range stays empty is 10 times
  // 0.9 to the 200th, less than 1e-8.
  const ReactionSettings settings{.presses = 1, .shortest_wait_s = 1.0, .longest_wait_s = 3.0};
  std::set<int> tenths;
  for (int i = 0; i < 200; ++i) {
    const ReactionTest test(settings, 0s, random_);
    int tenth = 0;
    while (!test.appears_at(nanoseconds_from_seconds(1.0 + 0.2 * (tenth + 1)))) {
      ++tenth;
    }
    EXPECT_FALSE(test.appears_at(999ms));
    tenths.insert(tenth);
  }
  EXPECT_EQ(tenths.size(), 10U);
  EXPECT_LE(*tenths.rbegin(), 9);
}

}  // namespace
}  // namespace foveola::study
