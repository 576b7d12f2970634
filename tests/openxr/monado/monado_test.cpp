// The whole program in a headset of Monado's, as it comes from Debian: its simulated one, which
// sways by itself, and one that tests move, with controllers. Neither has an eye tracker.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/end_to_end/preview/headset_run.h"
#include "tests/end_to_end/preview/preview_command.h"
#include "tests/matchers.h"
#include "tests/openxr/monado/monado_service.h"
#include "tests/renderer/headset/worn_headset.h"
#include "tests/renderer/window/patterned_film.h"

namespace foveola::test {
namespace {

using std::chrono::milliseconds;

/// How the simulated head is turned so long after its service made it: Monado's simulated_hmd.c.
Quat swaying_head(double since_s) {
  const auto swing = [&](double half_period_s) {
    return static_cast<float>(std::sin(since_s / half_period_s * std::numbers::pi));
  };
  return glm::normalize(Quat(1.0F, swing(6.0) / 64.0F, swing(8.0) / 16.0F, swing(8.0) / 64.0F));
}
constexpr double swaying_period_s = 48.0;

double degrees_between(const Quat& a, const Quat& b) {
  const double cosine = std::min(1.0, std::abs(static_cast<double>(glm::dot(a, b))));
  return degrees(2.0 * std::acos(cosine));
}

XrPosef turned(const Quat& orientation, const XrVector3f& position) {
  return {{orientation.x, orientation.y, orientation.z, orientation.w}, position};
}

/// Canted outwards, each seeing farther to its own side, and nothing that Monado's mask hides.
Wearer with_canted_eyes() {
  Wearer wearer;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const bool is_left = eye == 0;
    wearer.eyes[eye] = turned(head_orientation({.azimuth_rad = radians(is_left ? -5.0 : 5.0)}),
                              {is_left ? -0.032F : 0.032F, 0.0F, 0.0F});
    wearer.fovs[eye] = {is_left ? -0.6F : -0.5F, is_left ? 0.5F : 0.6F, 0.5F, -0.55F};
  }
  return wearer;
}

class MonadoPresenter : public ::testing::Test {
 protected:
  XServer server_;
};

TEST_F(MonadoPresenter, FollowsTheSwayingHead) {
  const MonadoService monado(MonadoService::Devices::simulated);
  WornHeadset worn;
  EXPECT_THAT(worn.presenter().facts().headset, HasSubstr("Simulated HMD"));
  EXPECT_THAT(worn.presenter().facts().runtime, HasSubstr("Monado"));
  worn.changes_until(HeadsetChange::got_focus);
  std::vector<std::pair<double, Quat>> heads;
  while (heads.size() < 200) {
    worn.show();
    // Some frames ago: between what is known of before and after, nothing is foretold.
    const Nanoseconds then = worn.now() - milliseconds(200);
    heads.emplace_back(seconds(then), *worn.presenter().motion().head_at(then));
  }
  double turned_deg = 0.0;
  for (const auto& [time_s, head] : heads) {
    turned_deg = std::max(turned_deg, degrees_between(head, heads.front().second));
  }
  EXPECT_GT(turned_deg, 2.0);
  // The room's axes are where the head looked at first, but level.
  double least_error_deg = 180.0;
  Quat room(1.0F, 0.0F, 0.0F, 0.0F);
  for (double began_s = 0.0; began_s < swaying_period_s; began_s += 0.005) {
    const auto [first_s, first_head] = heads.front();
    const Quat tried = first_head * glm::conjugate(swaying_head(first_s - began_s));
    std::vector<double> errors_deg;
    for (const auto& [time_s, head] : heads) {
      errors_deg.push_back(degrees_between(head, tried * swaying_head(time_s - began_s)));
    }
    // Of nine in ten: where the machine was held up, between two heads that are far apart, the head
    // is known less well.
    const auto tenth = errors_deg.begin() + std::ssize(errors_deg) * 9 / 10;
    std::ranges::nth_element(errors_deg, tenth);
    if (const double error_deg = *tenth; error_deg < least_error_deg) {
      least_error_deg = error_deg;
      room = tried;
    }
  }
  EXPECT_LT(least_error_deg, 0.1);
  EXPECT_NEAR(room.x, 0.0F, 2e-3F);
  EXPECT_NEAR(room.z, 0.0F, 2e-3F);
  const RgbImage picture = worn.shown_picture();
  EXPECT_EQ(max_component(picture.at(0, 0)), 0.0F) << "Monado's mask hides the corners";
  EXPECT_GT(max_component(picture.at(picture.width / 2, picture.height / 2)), 0.02F);
}

TEST_F(MonadoPresenter, ShowsTheEyeWhatTheProcessorDraws) {
  const MonadoService monado(MonadoService::Devices::remote);
  Wearer wearer = with_canted_eyes();
  const Quat head = head_orientation({.azimuth_rad = radians(30.0), .elevation_rad = radians(12.0)},
                                     radians(20.0));
  wearer.head = turned(head, {0.0F, 1.6F, 0.0F});
  monado.play(wearer);
  WornHeadset worn;
  const HeadsetFacts& facts = worn.presenter().facts();
  EXPECT_NEAR(facts.cant_deg(0), 5.0, 0.01);
  EXPECT_NEAR(facts.cant_deg(1), 5.0, 0.01);
  worn.presenter().motion().face({.azimuth_rad = radians(100.0)});
  worn.show();
  const RgbImage picture = worn.shown_picture();
  const Quat world_from_room = head_orientation({.azimuth_rad = radians(100.0)});
  const Quat cant = head_orientation({.azimuth_rad = radians(-5.0)});
  const ShownView view{.viewport = viewport_of(world_from_room * head * cant, facts.eyes[0]),
                       .part = {.origin = IVec2(0), .size = facts.eye_px[0]}};
  expect_like_the_processors(picture, view, {}, worn.film(), worn.workers());
}

TEST_F(MonadoPresenter, PassesOnWhatAControllerSays) {
  const MonadoService monado(MonadoService::Devices::remote);
  Wearer wearer;
  monado.play(wearer);
  WornHeadset worn;
  worn.changes_until(HeadsetChange::got_focus);
  const auto press = [&](const HeldController& held, int key) {
    wearer.right_hand = held;
    monado.play(wearer);
    EXPECT_THAT(worn.keys(1), ElementsAre(std::pair(key, true)));
    wearer.right_hand = {};
    monado.play(wearer);
    EXPECT_THAT(worn.keys(1), ElementsAre(std::pair(key, false)));
  };
  press({.trigger = true}, GLFW_KEY_SPACE);
  press({.a = true}, GLFW_KEY_ENTER);
  press({.b = true}, GLFW_KEY_TAB);
  press({.thumbstick = {0.9F, 0.1F}}, GLFW_KEY_RIGHT);
  press({.thumbstick = {0.1F, -0.9F}}, GLFW_KEY_DOWN);
}

TEST_F(MonadoPresenter, FindsItAgainOnceItsServiceIsRestarted) {
  std::optional<MonadoService> monado(MonadoService::Devices::simulated);
  WornHeadset worn;
  worn.changes_until(HeadsetChange::got_focus);
  monado.reset();
  worn.changes_until(HeadsetChange::lost);
  worn.show();  // nobody waits for it
  monado.emplace(MonadoService::Devices::simulated);
  worn.changes_until(HeadsetChange::found);
  worn.changes_until(HeadsetChange::got_focus);
  EXPECT_GT(max_component(worn.shown_picture().at(160, 120)), 0.02F);
}

class MonadoPreview : public PreviewCommand {};

TEST_F(MonadoPreview, RunsForAMinute) {
  const MonadoService monado(MonadoService::Devices::simulated);
  double brightness = 0.0;
  const nlohmann::json report = preview_while(
      [&](XUser& user) {
        std::this_thread::sleep_for(std::chrono::seconds(60));
        brightness = user.brightness_at(title_, 100, 80);
        user.type("Escape");
      },
      {"--headset", "--method", "vp", "--fill-unsampled"});
  EXPECT_EQ(report.at("display"), "openxr");
  EXPECT_THAT(report.at("headset_changes"), ElementsAre("the headset shows this"));
  EXPECT_GT(report.at("frame_count"), 200);
  EXPECT_GT(brightness, 0.02) << "what the left eye sees";
}

/// Presses what goes on, what marks and what chooses, one after the other, for as long as it lives,
/// and turns the head meanwhile.
class BusyHands {
 public:
  explicit BusyHands(const MonadoService& monado)
      : thread_([&monado](const std::stop_token& stop) {
          const std::array presses = {HeldController{.a = true}, HeldController{.trigger = true},
                                      HeldController{.thumbstick = {1.0F, 0.0F}}};
          Wearer wearer = with_canted_eyes();
          for (std::size_t press = 0; !stop.stop_requested(); ++press) {
            const double azimuth_deg = 5.0 * std::sin(0.1 * static_cast<double>(press));
            wearer.head =
                turned(head_orientation({.azimuth_rad = radians(azimuth_deg)}), {0.0F, 1.6F, 0.0F});
            wearer.right_hand = presses[press % presses.size()];
            monado.play(wearer);
            std::this_thread::sleep_for(milliseconds(150));
            wearer.right_hand = {};
            monado.play(wearer);
            std::this_thread::sleep_for(milliseconds(150));
          }
        }) {}

 private:
  std::jthread thread_;
};

class MonadoRun : public HeadsetRun {};

TEST_F(MonadoRun, AWholeSessionByControllers) {
  const MonadoService monado(MonadoService::Devices::remote);
  participant_.write_protocol(R"(
methods = ["od", "vp"]
phases = ["consent", "trials"]
)",
                              R"(
[texts]
consent = "You will look at pictures."
)" + std::string(short_look));
  const BusyHands hands(monado);
  participant_.begin({"--headset"});
  EXPECT_EQ(participant_.program().wait_for_end(), 0) << participant_.program().said();
  EXPECT_THAT(participant_.ask("SELECT state FROM session"), Each("completed"));
  EXPECT_EQ(recorded_marks().size(), 4U);
  const nlohmann::json found = devices();
  EXPECT_EQ(found.at("headset").at("has_eye_tracker"), false);
  EXPECT_EQ(found.at("headset").at("eyes").size(), 2U);
  const ProgramResult replayed = participant_.replay();
  EXPECT_EQ(replayed.exit_code, 0) << replayed.errors;
  EXPECT_THAT(replayed.output, AllOf(ContainsRegex("hall, od.*bit-identical"),
                                     ContainsRegex("hall, vp.*bit-identical")));
}

}  // namespace
}  // namespace foveola::test
