#include "study/console/session_status.h"

#include <nlohmann/json.hpp>

#include "tests/matchers.h"

namespace foveola::study {
namespace {

TEST(SessionStatus, FramesAreToldByRateAndLateness) {
  EXPECT_EQ(words_for(FrameStatus{.refresh_rate_hz = 60.0}), "measuring");
  EXPECT_EQ(words_for(FrameStatus{.rate_hz = 59.84, .refresh_rate_hz = 60.0}),
            "59.8 a second of 60");
  EXPECT_EQ(
      words_for(FrameStatus{.rate_hz = 89.9, .refresh_rate_hz = 89.95, .frames = 812, .late = 2}),
      "89.9 a second of 89.95; 2 of 812 late in this trial");
}

TEST(SessionStatus, GazeIsToldByValidityAndAge) {
  EXPECT_EQ(words_for(GazeStatus{.eye = "tracked"}), "tracked; no samples");
  EXPECT_EQ(words_for(GazeStatus{.eye = "tracked", .valid = 0.97, .age_s = 0.012}),
            "tracked; 97 % valid, the newest 12 ms old");
  EXPECT_EQ(words_for(GazeStatus{.eye = "tracked", .valid = 0.0, .age_s = 42.4}),
            "tracked; 0 % valid, the newest 42 s old");
}

TEST(SessionStatus, WhatIsNoPersonsEyeIsToldInLargeLetters) {
  EXPECT_THAT(words_for(GazeStatus{.eye = "simulated"}), HasSubstr("THE EYE IS SIMULATED"));
  EXPECT_THAT(words_for(GazeStatus{.eye = "recorded"}), HasSubstr("THE EYE IS RECORDED"));
  EXPECT_THAT(words_for(GazeStatus{.eye = "pointer"}),
              HasSubstr("THE MOUSE POINTER REPLACES THE EYE"));
}

TEST(SessionStatus, WarnsOfLateFramesFromTheAnalysissLimitOn) {
  EXPECT_FALSE(warning_of(FrameStatus{.frames = 300, .late = 3}));
  const auto warning = warning_of(FrameStatus{.frames = 299, .late = 3});
  ASSERT_TRUE(warning);
  EXPECT_EQ(warning->kind, WarningKind::late_frames);
  EXPECT_THAT(warning->text, HasSubstr("3 of this trial's 299 frames"));
  EXPECT_FALSE(warning_of(FrameStatus{.frames = 10, .late = 2})) << "too few to tell";
}

TEST(SessionStatus, AWarningArisesOnceWhateverItsFigures) {
  const StatusWarning late{WarningKind::late_frames, "3"};
  const StatusWarning later{WarningKind::late_frames, "4"};
  const StatusWarning lost{WarningKind::no_gaze, "none"};
  EXPECT_EQ(new_warnings({}, {late}).size(), 1U);
  EXPECT_THAT(new_warnings({late}, {later}), IsEmpty());
  const std::vector<StatusWarning> new_ones = new_warnings({late}, {later, lost});
  ASSERT_EQ(new_ones.size(), 1U);
  EXPECT_EQ(new_ones.front().text, "none");
}

TEST(SessionStatus, WhoPressesNoKeyForMinutesIsNamed) {
  using std::chrono::seconds;
  EXPECT_FALSE(warning_of(seconds(179)));
  EXPECT_EQ(warning_of(seconds(180))->kind, WarningKind::no_key);
  EXPECT_THAT(warning_of(seconds(7 * 60 + 59))->text, HasSubstr("for 7 minutes"));
}

TEST(SessionStatus, MachinesReadAllOfIt) {
  const nlohmann::ordered_json json =
      json_of(SessionStatus{.participant = "P1",
                            .time = std::chrono::milliseconds(1500),
                            .now = "rating",
                            .frames = {.rate_hz = 60.0, .refresh_rate_hz = 60.0, .frames = 9},
                            .gaze = {.eye = "tracked"},
                            .warnings = {{WarningKind::awaits_gaze, "Waits."}}});
  EXPECT_EQ(json["participant"], "P1");
  EXPECT_EQ(json["time_s"], 1.5);
  EXPECT_EQ(json["frames"]["frames"], 9);
  EXPECT_TRUE(json["gaze"]["valid"].is_null());
  EXPECT_EQ(json["warnings"][0]["kind"], "awaits_gaze");
  EXPECT_EQ(json["warnings"][0]["text"], "Waits.");
}

TEST(SessionStatus, WarningsHaveNamesOfTheirOwn) {
  EXPECT_THAT((std::vector<std::string>{
                  name_of(WarningKind::no_focus), name_of(WarningKind::no_key),
                  name_of(WarningKind::awaits_gaze), name_of(WarningKind::no_gaze),
                  name_of(WarningKind::late_frames), name_of(WarningKind::slow_drawing),
                  name_of(WarningKind::slow_record)}),
              ElementsAre("no_focus", "no_key", "awaits_gaze", "no_gaze", "late_frames",
                          "slow_drawing", "slow_record"));
}

}  // namespace
}  // namespace foveola::study
