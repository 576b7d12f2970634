#include "renderer/commands/gaze_filter_option.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(GazeFilterOption, NamesTheFiltersThatAreWanted) {
  EXPECT_EQ(parse_gaze_filter("none"), GazeFilterSettings{});
  EXPECT_EQ(
      parse_gaze_filter("hold,one-euro,extrapolate=0.03"),
      (GazeFilterSettings{.one_euro = OneEuroSettings{}, .extrapolate_s = 0.03, .hold_s = 0.6}));
  EXPECT_EQ(parse_gaze_filter("hold=0.25"), GazeFilterSettings{.hold_s = 0.25});
  EXPECT_EQ(parse_gaze_filter("one-euro=2:0.5:8"),
            (GazeFilterSettings{.one_euro = OneEuroSettings{.min_cutoff_hz = 2.0,
                                                            .beta_per_deg = 0.5,
                                                            .derivative_cutoff_hz = 8.0}}));
}

TEST(GazeFilterOption, SaysWhatIsWrongAndWhatToGive) {
  const auto expect_refused = [](const std::string& text, const std::string& what) {
    EXPECT_THAT([&] { parse_gaze_filter(text); },
                ThrowsMessage<UsageError>(AllOf(StartsWith("--gaze-filter: "), HasSubstr(what))))
        << text;
  };
  expect_refused("", "'' is not a gaze filter");
  expect_refused("kalman", "'kalman' is not a gaze filter; give none, or ");
  expect_refused("hold,none", "'none' is not a gaze filter");
  expect_refused("hold,", "'' is not a gaze filter");
  expect_refused(
      "hold=0.7",
      "'0.7' is not a time in seconds to hold a gaze for; give a number from 0.001 to 0.6");
  expect_refused("hold=", "'' is not a time");
  expect_refused("extrapolate", "'extrapolate' needs a time");
  expect_refused("extrapolate=0", "from 0.001 to 0.1");
  expect_refused("extrapolate=nan", "from 0.001 to 0.1");
  expect_refused("one-euro=1:2", "'1:2' is not a 1-Euro filter");
  expect_refused("one-euro=0:0.3:10", "'0' is not a cutoff frequency");
  expect_refused("one-euro=1:-1:10", "'-1' is not a beta");
  expect_refused("hold,hold=0.3", "'hold' is given twice");
}

}  // namespace
}  // namespace foveola
