#include "renderer/base/clock.h"

#include "renderer/base/work/work_scope.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(UtcNow, IsIso8601) {
  EXPECT_THAT(utc_now(), MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:"
                                      "[0-9]{2}\\.[0-9]{3}Z"));
}

TEST(UtcText, CountsFrom1970) {
  EXPECT_EQ(utc_text(Nanoseconds(0)), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(utc_text(std::chrono::milliseconds(86'461'001)), "1970-01-02T00:01:01.001Z");
  EXPECT_EQ(utc_text(Nanoseconds(1'999'999)), "1970-01-01T00:00:00.001Z");
}

TEST(HumanDuration, UsesTheUnitThatFits) {
  EXPECT_EQ(human_duration(0.25), "250 ms");
  EXPECT_EQ(human_duration(12.4), "12 s");
  EXPECT_EQ(human_duration(185.0), "3 m 05 s");
  EXPECT_EQ(human_duration(7800.0), "2 h 10 m");
}

}  // namespace
}  // namespace foveola
