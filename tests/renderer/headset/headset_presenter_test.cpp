// What is shown in a headset that follows a script, and what is learned from it.
#include "renderer/headset/headset_presenter.h"

#include <optional>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/headset/saved_pictures.h"
#include "tests/renderer/headset/worn_headset.h"
#include "tests/renderer/window/patterned_film.h"
#include "tests/waiting.h"
#include "tests/x_server.h"

namespace foveola {
namespace {

/// Small pictures, for a machine that draws with its processor.
const std::string small_eyes = R"("eyes": [
    {"recommended_px": [120, 100], "cant_deg": 5,
     "fov_deg": {"left": -50, "right": 40, "up": 42, "down": -46}},
    {"recommended_px": [120, 100], "cant_deg": -5,
     "fov_deg": {"left": -40, "right": 50, "up": 42, "down": -46}}])";

class HeadsetPresenterTest : public ::testing::Test {
 protected:
  /// A headset with such a wearer.
  void wear(const std::string& script, const std::string& refresh_hz = "60") {
    headset_.emplace("{\"refresh_hz\": " + refresh_hz + ", " + small_eyes + script + "}");
    worn_.emplace();
  }

  void TearDown() override {
    worn_.reset();
    if (headset_ && finds_nothing_wrong_) {
      EXPECT_EQ(headset_->found_invalid(), "");
    }
  }

  HeadsetPresenter& presenter() { return worn_->presenter(); }

  std::int64_t newest_frame() const { return headset_->newest_frame(); }
  void wait_for_frame(std::int64_t number) const { test::wait_for_frame(*headset_, number); }

  test::XServer server_;
  std::optional<test::ScriptedHeadset> headset_;
  std::optional<test::WornHeadset> worn_;
  bool finds_nothing_wrong_ = true;
};

TEST_F(HeadsetPresenterTest, TellsWhatTheRuntimeTells) {
  // A frame is shown ten seconds after it was asked for, and no machine is later than that.
  wear(R"(, "system_name": "A headset", "real_time": false)", "0.1");
  const HeadsetFacts& facts = presenter().facts();
  EXPECT_EQ(facts.headset, "A headset");
  EXPECT_TRUE(facts.has_eye_tracker);
  EXPECT_EQ(facts.eye_px[1], IVec2(120, 100));
  EXPECT_NEAR(facts.refresh_rate_hz, 0.1, 1e-6);
  EXPECT_NEAR(facts.cant_deg(0), 5.0, 1e-3);
  EXPECT_NEAR(facts.cant_deg(1), 5.0, 1e-3);
  EXPECT_GT(facts.eyes[0].lens.axis.x, 0.5F) << "it sees farther to the left";
  EXPECT_LT(facts.eyes[1].lens.axis.x, 0.5F);
  EXPECT_GT(facts.both.horizontal_deg, 108.0);
  EXPECT_GT(facts.display_delay, Nanoseconds(0));
  EXPECT_LE(facts.display_delay, std::chrono::seconds(10));
}

TEST_F(HeadsetPresenterTest, ShowsEachEyeWhatTheProcessorDraws) {
  wear(R"(, "head": [{"time": 0, "yaw_deg": 30, "pitch_deg": 12, "roll_deg": -20}],
          "save_pictures": true)");
  presenter().motion().face({.azimuth_rad = radians(100.0)});
  worn_->show();
  const std::int64_t shown = newest_frame();
  wait_for_frame(shown + 3);
  for (int eye = 0; eye < 2; ++eye) {
    SCOPED_TRACE(eye);
    const RgbImage picture = test::saved_picture(*headset_, shown + 2, eye);
    const Quat head = head_orientation(
        {.azimuth_rad = radians(100.0 - 30.0), .elevation_rad = radians(12.0)}, radians(20.0));
    const double outwards_deg = eye == 0 ? -5.0 : 5.0;
    const Quat cant = head_orientation({.azimuth_rad = radians(outwards_deg)});
    const ShownView view{.viewport = viewport_of(
                             head * cant, presenter().facts().eyes[static_cast<std::size_t>(eye)]),
                         .part = {.origin = IVec2(0), .size = {120, 100}}};
    test::expect_like_the_processors(picture, view, {}, worn_->film(), worn_->workers());
  }
}

TEST_F(HeadsetPresenterTest, ResamplesNothingThatTheLensesNeverShow) {
  // The right half of what each eye sees up to 45 degrees.
  headset_.emplace(R"({"refresh_hz": 60, "save_pictures": true, "eyes": [
      {"recommended_px": [120, 100], "fov_deg": {"left": -45, "right": 45, "up": 45, "down": -45},
       "mask": {"vertices": [[0, -2], [2, -2], [2, 2], [0, 2]], "indices": [0, 1, 2, 0, 2, 3]}},
      {"recommended_px": [120, 100]}]})");
  worn_.emplace();
  worn_->show();
  const std::int64_t shown = newest_frame();
  wait_for_frame(shown + 3);
  const RgbImage picture = test::saved_picture(*headset_, shown + 2, 0);
  double seen = 0.0;
  double hidden = 0.0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      (x < picture.width / 2 ? seen : hidden) += max_component(picture.at(x, y));
    }
  }
  EXPECT_GT(seen, 100.0);
  EXPECT_EQ(hidden, 0.0);
}

TEST_F(HeadsetPresenterTest, TheWindowShowsWhatTheLeftEyeSees) {
  wear("");
  worn_->show();
  test::XUser user(server_.display());
  double brightness = 0.0;
  test::wait_until("what the left eye sees", [&] {
    worn_->show();
    for (int x = 60; x < 260; x += 20) {
      brightness = std::max(brightness, user.brightness_at("Foveola", x, 120));
    }
    return brightness > 0.2;
  });
}

// In 320x240 pixels there is room for 288x240 of a picture of 120x100.
TEST_F(HeadsetPresenterTest, TheMousePointsAtWhatTheWindowShows) {
  wear("");
  const ViewGeometry geometry = presenter().in_window({}, {320, 240});
  const double horizon_px =
      240.0 * std::tan(radians(42.0)) / (std::tan(radians(42.0)) + std::tan(radians(46.0)));
  const auto azimuth_deg = [&](double x_px) {
    const Vec3 pointed_at = direction_below(geometry, {x_px, horizon_px}, 240);
    EXPECT_NEAR(pointed_at.y, 0.0F, 1e-4F);
    return degrees(azimuth_elevation(pointed_at).azimuth_rad);
  };
  EXPECT_NEAR(azimuth_deg(16.0), -50.0 - 5.0, 0.01) << "canted outwards";
  EXPECT_NEAR(azimuth_deg(16.0 + 288.0), 40.0 - 5.0, 0.01);
}

// The head turns, and whoever renders takes his time.
TEST_F(HeadsetPresenterTest, FollowsTheHeadWithoutNewFrames) {
  wear(R"(, "head": [{"time": 0}, {"time": 100, "yaw_deg": 3000}])");
  worn_->show();
  const std::int64_t shown = newest_frame();
  wait_for_frame(shown + 10);
  std::optional<double> before;
  for (const nlohmann::json& frame : headset_->frames()) {
    if (frame.at("frame") > shown && !frame.at("orientations").empty()) {
      const nlohmann::json& q = frame.at("orientations")[0];
      const double yaw_deg = degrees(2.0 * std::atan2(q[1].get<double>(), q[3].get<double>()));
      if (before) {
        EXPECT_NEAR(std::remainder(yaw_deg - *before, 360.0), 0.5, 0.1) << "30 degrees a second";
      }
      before = yaw_deg;
    }
  }
  EXPECT_TRUE(before);
}

TEST_F(HeadsetPresenterTest, TellsWhereTheEyesLook) {
  wear(R"(, "gaze": [{"time": 0, "yaw_deg": -10, "pitch_deg": 5}],
          "gaze_gaps": [{"from": 0.5, "to": 1, "kind": "blink"},
                        {"from": 1.5, "to": 2, "kind": "lost"}],
          "gaze_sample_time": [{"time": 0, "policy": "true", "delay_ms": 12},
                               {"time": 2, "policy": "zero"}])");
  HeadsetEyes eyes(presenter().motion(), true);
  std::vector<GazeSample> samples;
  test::wait_until("gaze", [&] {
    eyes.poll(worn_->now(), samples);
    return newest_frame() > 150;
  });
  const Vec3 looked_at =
      direction_from({.azimuth_rad = radians(10.0), .elevation_rad = radians(5.0)});
  int valid = 0;
  int blinks = 0;
  int without_time = 0;
  for (const GazeSample& sample : samples) {
    if (sample.valid) {
      EXPECT_LT(degrees(angle_between(sample.direction, looked_at)), 0.01);
    }
    valid += sample.valid ? 1 : 0;
    blinks += sample.valid ? 0 : 1;
    without_time += sample.is_time_known ? 0 : 1;
  }
  EXPECT_GT(valid, 60);
  EXPECT_NEAR(blinks, 30, 3);
  EXPECT_GT(without_time, 20);
  EXPECT_TRUE(
      std::is_sorted(samples.begin(), samples.end(),
                     [](const GazeSample& a, const GazeSample& b) { return a.time < b.time; }));
}

TEST_F(HeadsetPresenterTest, PassesOnWhatIsPressed) {
  wear(R"(, "inputs": [
      {"time": 0.2, "path": "/user/hand/right/input/select/click", "pressed": true},
      {"time": 0.4, "path": "/user/hand/right/input/select/click", "pressed": false}])");
  EXPECT_THAT(worn_->keys(2),
              ElementsAre(std::pair(GLFW_KEY_SPACE, true), std::pair(GLFW_KEY_SPACE, false)));
}

TEST_F(HeadsetPresenterTest, PassesOnWhatAGamepadSays) {
  wear(R"(, "interaction_profiles": ["/interaction_profiles/microsoft/xbox_controller"], "inputs": [
      {"time": 0.1, "path": "/user/gamepad/input/b/click", "pressed": true},
      {"time": 0.2, "path": "/user/gamepad/input/b/click", "pressed": false},
      {"time": 0.3, "path": "/user/gamepad/input/dpad_down/click", "pressed": true},
      {"time": 0.4, "path": "/user/gamepad/input/dpad_down/click", "pressed": false},
      {"time": 0.5, "path": "/user/gamepad/input/thumbstick_left", "xy": [0.2, 0.1]},
      {"time": 0.6, "path": "/user/gamepad/input/thumbstick_left", "xy": [-0.9, 0.1]},
      {"time": 0.7, "path": "/user/gamepad/input/thumbstick_left", "xy": [0.2, 0.8]},
      {"time": 0.8, "path": "/user/gamepad/input/thumbstick_left", "xy": [0, 0]}])");
  EXPECT_THAT(worn_->keys(8),
              ElementsAre(std::pair(GLFW_KEY_ENTER, true), std::pair(GLFW_KEY_ENTER, false),
                          std::pair(GLFW_KEY_DOWN, true), std::pair(GLFW_KEY_DOWN, false),
                          std::pair(GLFW_KEY_LEFT, true), std::pair(GLFW_KEY_LEFT, false),
                          std::pair(GLFW_KEY_UP, true), std::pair(GLFW_KEY_UP, false)));
}

TEST_F(HeadsetPresenterTest, TellsOfRecenteringAndOfFocus) {
  wear(R"(, "events": [{"time": 0.2, "event": "recentre", "yaw_deg": 90},
                       {"time": 0.4, "event": "focus_lost"},
                       {"time": 0.6, "event": "hidden"},
                       {"time": 0.8, "event": "focus_gained"}])");
  EXPECT_THAT(
      worn_->changes_until(HeadsetChange::lost_focus),
      ElementsAre(HeadsetChange::got_focus, HeadsetChange::recentred, HeadsetChange::lost_focus));
  EXPECT_THAT(worn_->changes_until(HeadsetChange::got_focus),
              ElementsAre(HeadsetChange::got_focus));
}

#ifdef XR_EXT_user_presence
TEST_F(HeadsetPresenterTest, TellsThatItIsTakenOffAndPutOn) {
  wear(R"(, "events": [{"time": 0.2, "event": "taken_off"}, {"time": 0.6, "event": "put_on"}])");
  EXPECT_THAT(worn_->changes_until(HeadsetChange::taken_off), Not(Contains(HeadsetChange::put_on)))
      << "nobody puts it on who wears it from the start";
  worn_->changes_until(HeadsetChange::put_on);
}
#endif

TEST_F(HeadsetPresenterTest, FindsALostHeadsetAgain) {
  wear(R"(, "events": [{"time": 0.2, "event": "session_loss", "session": 1}])");
  worn_->changes_until(HeadsetChange::lost);
  worn_->show();  // nobody waits for it
  worn_->changes_until(HeadsetChange::found);
  const std::int64_t shown = newest_frame();
  wait_for_frame(shown + 1);
  worn_->show();
}

TEST_F(HeadsetPresenterTest, IsLostWhenItsRuntimeFailsAndFoundAgain) {
  wear(R"(, "failures": [{"function": "xrEndFrame", "result": "XR_ERROR_RUNTIME_FAILURE",
                          "time": 0.3, "times": 1}])");
  worn_->changes_until(HeadsetChange::lost);
  EXPECT_EQ(worn_->changes_until(HeadsetChange::found).size(), 1U);
  worn_->show();
}

TEST_F(HeadsetPresenterTest, IsToldToEndByTheRuntime) {
  wear(R"(, "events": [{"time": 0.2, "event": "exit"}])");
  worn_->changes_until(HeadsetChange::exit_wanted);
  worn_->show();  // nobody waits for it
}

TEST_F(HeadsetPresenterTest, SaysThatTheHeadsetIsNotThere) {
  finds_nothing_wrong_ = false;
  EXPECT_THAT(
      [&] {
        wear(R"(, "failures": [{"function": "xrGetSystem",
                                "result": "XR_ERROR_FORM_FACTOR_UNAVAILABLE"}])");
      },
      ThrowsMessage<Error>(HasSubstr("not there")));
}

TEST_F(HeadsetPresenterTest, SaysThatThereIsNoRuntime) {
  const scenes::EnvironmentVariable runtime("XR_RUNTIME_JSON", "/nowhere/runtime.json");
  EXPECT_THAT([&] { worn_.emplace(); }, ThrowsMessage<Error>(HasSubstr("runtime")));
}

TEST_F(HeadsetPresenterTest, SaysThatTheRuntimeCannotDrawWithOpenGl) {
  finds_nothing_wrong_ = false;
  EXPECT_THAT([&] { wear(R"(, "extensions": ["XR_KHR_convert_timespec_time"])"); },
              ThrowsMessage<Error>(HasSubstr("XR_KHR_opengl_enable")));
}

}  // namespace
}  // namespace foveola
