#include "renderer/window/live/preview_controls.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/matchers.h"

namespace foveola {
namespace {

PreviewChoices four_methods() { return {.methods = {"fv", "od", "vp", "hybrid"}}; }

TEST(PreviewControlsTest, EveryLetterDoesSomethingElse) {
  std::set<PreviewAction> actions;
  int letters = 0;
  for (char32_t c = ' '; c < 127; ++c) {
    if (const auto action = action_of(CharacterTyped{c})) {
      ++letters;
      actions.insert(*action);
    }
  }
  EXPECT_THAT(actions, SizeIs(letters));
  const std::string help = fmt::format("{}", fmt::join(help_lines(), "\n"));
  for (char32_t c = '!'; c < 127; ++c) {
    if (action_of(CharacterTyped{c})) {
      EXPECT_THAT(help, HasSubstr(fmt::format("{}  ", static_cast<char>(c))));
    }
  }
}

TEST(PreviewControlsTest, TheHelpFitsASmallWindow) {
  // 800x450, in letters of 7x13 pixels.
  EXPECT_LE(help_lines().size(), 31U);
  EXPECT_THAT(help_lines(), Each(SizeIs(testing::Le(108U))));
}

TEST(PreviewControlsTest, OverlaysAndTheToneCurveComeAndGo) {
  const std::vector<std::pair<PreviewAction, bool PreviewChoices::*>> overlays = {
      {PreviewAction::show_gaze, &PreviewChoices::shows_gaze},
      {PreviewAction::show_rings, &PreviewChoices::shows_rings},
      {PreviewAction::show_density, &PreviewChoices::shows_density},
      {PreviewAction::show_frame_times, &PreviewChoices::shows_frame_times},
      {PreviewAction::show_latency, &PreviewChoices::shows_latency},
      {PreviewAction::show_view, &PreviewChoices::shows_view},
      {PreviewAction::show_warnings, &PreviewChoices::shows_warnings},
      {PreviewAction::show_help, &PreviewChoices::shows_help}};
  PreviewChoices choices = four_methods();
  for (const bool is_on : {true, false}) {
    for (const auto& [action, shows] : overlays) {
      EXPECT_EQ(choices.*shows, !is_on);
      EXPECT_FALSE(follow(action, choices));
      EXPECT_EQ(choices.*shows, is_on);
    }
    EXPECT_FALSE(follow(PreviewAction::next_curve, choices));
    EXPECT_EQ(choices.look.curve, is_on ? ToneCurve::filmic : ToneCurve::plain);
  }
}

TEST(PreviewControlsTest, SamplesAreCutAtAMultipleOfWhite) {
  PreviewChoices choices = four_methods();
  EXPECT_TRUE(std::isinf(largest_radiance(choices)));
  EXPECT_FALSE(follow(PreviewAction::brighter, choices));
  EXPECT_TRUE(follow(PreviewAction::cut_fireflies, choices));
  EXPECT_NEAR(largest_radiance(choices), 4.0 / std::sqrt(2.0), 1e-5) << "half a stop brighter";
  EXPECT_TRUE(follow(PreviewAction::darker, choices)) << "the limit is another one";
  EXPECT_NEAR(largest_radiance(choices), 4.0, 1e-6);
  EXPECT_TRUE(follow(PreviewAction::cut_fireflies, choices));
  EXPECT_TRUE(std::isinf(largest_radiance(choices)));
}

TEST(PreviewControlsTest, KeysActWhenTheyGoDown) {
  EXPECT_THAT(action_of(KeyMoved{.key = GLFW_KEY_ESCAPE, .is_down = true}),
              Optional(PreviewAction::close));
  EXPECT_EQ(action_of(KeyMoved{.key = GLFW_KEY_ESCAPE, .is_down = false}), std::nullopt);
  EXPECT_EQ(action_of(KeyMoved{.key = GLFW_KEY_M, .is_down = true}), std::nullopt);
}

TEST(PreviewControlsTest, MethodsComeRound) {
  PreviewChoices choices = four_methods();
  std::vector<std::string> seen;
  for (int i = 0; i < 5; ++i) {
    seen.push_back(method_text(choices));
    EXPECT_TRUE(follow(PreviewAction::next_method, choices));
  }
  EXPECT_THAT(seen, ElementsAre("fv", "od", "vp", "hybrid:0.90*fv+0.10*od", "fv"));
}

TEST(PreviewControlsTest, SharesMatterToTheHybridOnly) {
  PreviewChoices choices = four_methods();
  EXPECT_FALSE(follow(PreviewAction::less_of_the_first, choices));
  choices.method = 3;
  EXPECT_TRUE(follow(PreviewAction::less_of_the_first, choices));
  EXPECT_EQ(method_text(choices), "hybrid:0.70*fv+0.30*od");
  for (int i = 0; i < 20; ++i) {
    follow(PreviewAction::less_of_the_first, choices);
  }
  EXPECT_EQ(method_text(choices), "hybrid:0.10*fv+0.90*od");
  for (int i = 0; i < 20; ++i) {
    follow(PreviewAction::more_of_the_first, choices);
  }
  EXPECT_EQ(method_text(choices), "hybrid:0.90*fv+0.10*od");
}

TEST(PreviewControlsTest, ExposureGoesByHalfStops) {
  PreviewChoices choices = four_methods();
  follow(PreviewAction::brighter, choices);
  follow(PreviewAction::brighter, choices);
  follow(PreviewAction::darker, choices);
  EXPECT_DOUBLE_EQ(choices.look.exposure_stops, 0.5);
}

TEST(PreviewControlsTest, OppositeKeysCancel) {
  TurnKeys keys;
  EXPECT_TRUE(keys.follow({.key = GLFW_KEY_RIGHT, .is_down = true}));
  EXPECT_EQ(keys.right(), 1);
  keys.follow({.key = GLFW_KEY_LEFT, .is_down = true});
  EXPECT_EQ(keys.right(), 0);
  keys.follow({.key = GLFW_KEY_RIGHT, .is_down = false});
  EXPECT_EQ(keys.right(), -1);
  EXPECT_FALSE(keys.follow({.key = GLFW_KEY_M, .is_down = true}));
}

}  // namespace
}  // namespace foveola
