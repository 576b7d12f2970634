// A preview and a person's whole session in a headset that follows a script.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/angles.h"
#include "renderer/gaze/calibration.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/preview/headset_run.h"
#include "tests/end_to_end/preview/preview_command.h"
#include "tests/matchers.h"
#include "tests/openxr/scripted_headset.h"

namespace foveola::test {
namespace {

/// Small pictures at 30 Hz, for a machine that draws with its processor, whose lenses show no upper
/// left corner.
const char* const small_headset = R"(
    "refresh_hz": 30, "interaction_profiles": ["/interaction_profiles/microsoft/xbox_controller"],
    "eyes": [{"recommended_px": [160, 144],
              "mask": {"vertices": [[-2, 2], [-2, -0.2], [0.2, 2]], "indices": [0, 1, 2]}},
             {"recommended_px": [160, 144],
              "mask": {"vertices": [[-2, 2], [-2, -0.2], [0.2, 2]], "indices": [0, 1, 2]}}])";

/// Somebody who presses one button after the other, four times a second: what goes on, what marks,
/// and what chooses.
std::string busy_thumbs() {
  nlohmann::json inputs = nlohmann::json::array();
  constexpr int presses = 2400;
  for (int press = 0; press < presses; ++press) {
    const char* const button = press % 3 == 0 ? "b" : press % 3 == 1 ? "a" : "dpad_right";
    const std::string path = fmt::format("/user/gamepad/input/{}/click", button);
    inputs.push_back({{"time", 0.25 * press}, {"path", path}, {"pressed", true}});
    inputs.push_back({{"time", 0.25 * press + 0.1}, {"path", path}, {"pressed", false}});
  }
  return inputs.dump();
}

std::string script(const std::string& more) {
  return fmt::format("{{{}, \"inputs\": {}{}}}", small_headset, busy_thumbs(), more);
}

class HeadsetPreview : public PreviewCommand {};

TEST_F(HeadsetPreview, FollowsTheHeadAndTheEyes) {
  const ScriptedHeadset headset(script(R"(, "head": [{"time": 0, "yaw_deg": -30, "roll_deg": 15}],
                 "gaze": [{"time": 0, "yaw_deg": -8}],
                 "gaze_sample_time": [{"time": 0, "policy": "true", "delay_ms": 10}])"));
  const std::string file = folder_ / "last.png";
  const ProgramResult result =
      succeeded(preview({"--headset", "--frames", "40", "--screenshot", file, "--fill-unsampled"}));
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json.at("display"), "openxr");
  EXPECT_EQ(json.at("tracker"), "openxr");
  EXPECT_EQ(json.at("frame_count"), 40);
  EXPECT_THAT(json.at("headset_changes"), Contains("the headset shows this"));
  EXPECT_THAT(json.at("last_view"), HasSubstr("--head 75,")) << "the camera looks along 45";
  const RgbImage picture = read_film_image(file).color;
  EXPECT_EQ(picture.width, 160);
  EXPECT_EQ(picture.height, 144);
  EXPECT_GT(picture.at(80, 72).g, 0.02F);
  EXPECT_EQ(headset.found_invalid(), "");
}

// The eyes look 6 degrees to the left all the while.
TEST_F(HeadsetPreview, ChecksTheTrackerInTheHeadset) {
  const char* const eye =
      R"({"recommended_px": [160, 144], "fov_deg": {"left": -40, "right": 40, "up": 40, "down": -40}})";
  const ScriptedHeadset headset(fmt::format(
      R"({{"refresh_hz": 30, "eyes": [{0}, {0}], "gaze": [{{"time": 0, "yaw_deg": 6}}]}})", eye));
  const auto json = preview_while(
      [this](XUser& user) {
        user.type("c");
        wait_for_target(user, 100, 80);
        wait_for_target(user, 100, 80, false);
        wait_until("the end of the check", [&] {
          return std::abs(user.brightness_at(title_, 30, 100) - 0.5) > 0.01 ||
                 std::abs(user.brightness_at(title_, 170, 100) - 0.5) > 0.01;
        });
        user.type("q");
      },
      {"--headset"});
  ASSERT_EQ(json.at("gaze_checks").size(), 1U);
  // How much a target counts depends on how many frames there were meanwhile.
  const Vec3 gaze = direction_from({.azimuth_rad = radians(-6.0)});
  std::vector<double> errors_deg;
  for (const Vec3& target : calibration_targets(5, 80.0, 80.0)) {
    errors_deg.push_back(degrees(angle_between(gaze, target)));
  }
  const double accuracy_deg = json.at("gaze_checks").at(0).at("accuracy_deg").get<double>();
  EXPECT_GT(accuracy_deg, std::ranges::min(errors_deg) + 1.0);
  EXPECT_LT(accuracy_deg, std::ranges::max(errors_deg) - 1.0);
  EXPECT_EQ(headset.found_invalid(), "");
}

const char* const session_keys = R"(
methods = ["vp", "fv"]
phases = ["consent", "validation", "trials"]
)";

std::string session_tables() {
  return R"(
[texts]
consent = "You will look at pictures."

[tracker.validation]
points = 5
max_accuracy_deg = 45
max_precision_deg = 10
max_data_loss = 1.0
)" + std::string(short_look);
}

TEST_F(HeadsetRun, AWholeSessionNeedsNoKeyboard) {
  const ScriptedHeadset headset(script(
      R"(, "head": [{"time": 0}, {"time": 10, "roll_deg": 10}, {"time": 600, "yaw_deg": 8}])"));
  participant_.write_protocol(session_keys, session_tables());
  participant_.begin({"--headset"});
  EXPECT_EQ(participant_.program().wait_for_end(), 0) << participant_.program().said();
  EXPECT_EQ(recorded_marks().size(), 4U);
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), Each("completed"));
  EXPECT_EQ(headset.found_invalid(), "");
  const nlohmann::json found = devices();
  EXPECT_EQ(found.at("display").at("profile"), "openxr");
  EXPECT_EQ(found.at("tracker").at("profile"), "openxr");
  EXPECT_EQ(found.at("headset").at("eyes").size(), 2U);
  EXPECT_EQ(found.at("display").at("seen").front().get<std::string>().front(), '0')
      << "the upper left corner";
  const ProgramResult replayed = succeeded(participant_.replay());
  EXPECT_THAT(replayed.output, AllOf(ContainsRegex("hall, vp.*bit-identical"),
                                     ContainsRegex("hall, fv.*bit-identical")));
}

// The script starts once the session has begun. In the first 2.5 seconds of it the buttons are not
// pressed often enough to end the session.
TEST_F(HeadsetRun, APauseComesWithWhateverIsSeenInstead) {
  const ScriptedHeadset headset(
      script(R"(, "events": [{"time": 0.5, "event": "recentre", "yaw_deg": 20},
                             {"time": 1, "event": "focus_lost"},
                             {"time": 1.5, "event": "focus_gained"},
                             {"time": 2.5, "event": "session_loss", "session": 1}],
                 "starts_with": ")" +
             (participant_.folder() / "begun").string() + "\""));
  participant_.write_protocol(session_keys, session_tables());
  participant_.begin({"--headset"});
  participant_.folder().write("begun", "");
  EXPECT_EQ(participant_.program().wait_for_end(), 0) << participant_.program().said();
  EXPECT_THAT(
      notes(),
      AllOf(Contains("the headset was recentred"), Contains("the headset shows something else"),
            Contains("the headset was lost"), Contains("the headset was found again")));
  EXPECT_GE(participant_.ask("SELECT 1 FROM event WHERE type = 'pause_requested'").size(), 1U);
  EXPECT_EQ(participant_.ask("SELECT 1 FROM event WHERE type = 'rated'").size(), 2U);
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), Each("completed"));
}

TEST_F(HeadsetRun, WithoutAHeadsetNothingIsBegun) {
  participant_.write_protocol(session_keys, session_tables());
  const ProgramResult result = participant_.run_besides("P1", {"--headset"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("headset"), Not(HasSubstr("Error ["))));
  EXPECT_THAT(participant_.ask("SELECT 1 FROM session"), IsEmpty());
}

}  // namespace
}  // namespace foveola::test
