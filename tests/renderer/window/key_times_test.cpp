#include "renderer/window/key_times.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

TEST(TimeOfStamp, IsTheEndOfItsMillisecond) {
  EXPECT_EQ(time_of_stamp(5000, microseconds(5'009'300)), milliseconds(5001));
}

TEST(TimeOfStamp, IsTheArrivalIfThatWasEarlier) {
  EXPECT_EQ(time_of_stamp(5000, microseconds(5'000'300)), microseconds(5'000'300));
}

TEST(TimeOfStamp, CountsModulo2To32) {
  constexpr std::int64_t round_ms = std::int64_t{1} << 32;
  EXPECT_EQ(time_of_stamp(7, milliseconds(3 * round_ms + 20)), milliseconds(3 * round_ms + 8));
  // The stamp's last millisecond of a round, read in the next.
  EXPECT_EQ(time_of_stamp(0xffff'ffff, milliseconds(round_ms + 3)), milliseconds(round_ms));
}

TEST(TimeOfStamp, AnImpossibleStampGivesTheArrival) {
  const Nanoseconds arrival = milliseconds(60'000);
  EXPECT_EQ(time_of_stamp(60'001, arrival), arrival) << "later than its arrival";
  EXPECT_EQ(time_of_stamp(50'000, arrival), milliseconds(50'001)) << "10 s under way";
  EXPECT_EQ(time_of_stamp(49'999, arrival), arrival) << "longer than that";
}

TEST(IsOfThisClock, WithinWhatItWasAskedBetween) {
  const Nanoseconds before = microseconds(8'000'900);
  const Nanoseconds after = microseconds(8'003'100);
  EXPECT_TRUE(is_of_this_clock(8000, before, after));
  EXPECT_TRUE(is_of_this_clock(8003, before, after));
  EXPECT_TRUE(is_of_this_clock(7999, before, after)) << "a clock of ticks of a millisecond";
  EXPECT_FALSE(is_of_this_clock(7998, before, after));
  EXPECT_FALSE(is_of_this_clock(8004, before, after));
}

TEST(IsOfThisClock, HoldsOverTheEndOfTheStamps) {
  constexpr std::int64_t round_ms = std::int64_t{1} << 32;
  EXPECT_TRUE(is_of_this_clock(0, milliseconds(round_ms - 1), milliseconds(round_ms + 1)));
}

}  // namespace
}  // namespace foveola
