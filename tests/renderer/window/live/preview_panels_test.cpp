#include "renderer/window/live/preview_panels.h"

#include <limits>

#include "tests/matchers.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;

/// Ten frames of 41 253 samples in a second: as many as a sphere has square degrees.
std::vector<LiveFrame> frames() {
  std::vector<LiveFrame> frames;
  for (int i = 0; i < 10; ++i) {
    LiveFrame frame{.start = milliseconds(100 * i), .shown = milliseconds(100 * i + 100)};
    frame.report.time = frame.start;
    frame.report.gaze_valid = true;
    frame.report.samples = 41'253;
    frames.push_back(frame);
  }
  return frames;
}

ShownNow shown() {
  return {.view = "view 60.0 x 36.0 degrees, true angles",
          .horizontal_fov_deg = 60.0,
          .camera = {1.5, 1.6, -3.25},
          .head = {radians(-30.0), radians(5.0)},
          .speed_m_per_s = 1.5,
          .exposure_stops = -0.5,
          .largest_radiance = std::numeric_limits<float>::infinity()};
}

TEST(PreviewPanelsTest, AViewIsOptionsOfTheCommandLine) {
  ShownNow now = shown();
  EXPECT_EQ(view_options(now), "--camera 1.5,1.6,-3.25 --head -30,5 --fov 60");
  now.horizontal_fov_deg.reset();
  EXPECT_EQ(view_options(now), "--camera 1.5,1.6,-3.25 --head -30,5");
}

TEST(PreviewPanelsTest, ThoseThatWereChosenAreShown) {
  const std::vector<LiveFrame> rendered = frames();
  const TrackerProfile tracker{.rate_hz = 70.0};
  const DisplayProfile display{.refresh_rate_hz = 60.0};
  const PanelContents contents{
      .frames = rendered, .tracker = tracker, .display = display, .shown = shown()};
  PreviewChoices choices{.methods = {"fv"}};
  EXPECT_THAT(preview_panels(choices, contents), IsEmpty());
  choices.shows_density = true;
  choices.shows_help = true;
  const std::vector<TextPanel> panels = preview_panels(choices, contents);
  ASSERT_THAT(panels, SizeIs(2));
  EXPECT_EQ(panels[0].lines, help_lines());
  EXPECT_TRUE(panels[1].has_density_scale);
}

TEST(PreviewPanelsTest, WarningsOfTheTerminalCanBeRead) {
  const TrackerProfile tracker{.rate_hz = 70.0};
  const DisplayProfile display{.refresh_rate_hz = 60.0};
  const std::vector<std::string> warnings = {"a texture is left out", "normals are replaced"};
  const PanelContents contents{.warnings = warnings, .tracker = tracker, .display = display};
  PreviewChoices choices{.methods = {"fv"}};
  EXPECT_THAT(preview_panels(choices, contents), IsEmpty());
  follow(*action_of(CharacterTyped{'w'}), choices);
  const std::vector<TextPanel> panels = preview_panels(choices, contents);
  ASSERT_THAT(panels, SizeIs(1));
  EXPECT_THAT(panels[0].lines, ElementsAre("warnings of the scene", "- a texture is left out",
                                           "- normals are replaced"));
}

TEST(PreviewPanelsTest, NotesAreTheMostImportant) {
  const TrackerProfile tracker{.rate_hz = 70.0};
  const DisplayProfile display{.refresh_rate_hz = 60.0};
  const std::vector<TextPanel> panels =
      preview_panels({.methods = {"fv"}, .shows_frame_times = true},
                     {.notes = {"no tracker"}, .tracker = tracker, .display = display});
  ASSERT_THAT(panels, SizeIs(2));
  EXPECT_THAT(panels[0].lines, ElementsAre("no tracker"));
}

using std::chrono::seconds;

TEST(PreviewMessagesTest, GoAfterAWhile) {
  PreviewMessages messages;
  messages.tell(seconds(0), "picture");
  messages.tell(seconds(1), "lost the monitor", MessageStay::long_enough);
  EXPECT_THAT(messages.lines(seconds(3)), ElementsAre("picture", "lost the monitor"));
  EXPECT_THAT(messages.lines(seconds(5)), ElementsAre("lost the monitor"));
  EXPECT_THAT(messages.lines(seconds(17)), IsEmpty());
}

TEST(PreviewMessagesTest, ResultsWaitForAKey) {
  PreviewMessages messages;
  messages.tell(seconds(0), "accuracy", MessageStay::until_key);
  EXPECT_THAT(messages.lines(seconds(1000)), ElementsAre("accuracy"));
  messages.answer_key();
  EXPECT_THAT(messages.lines(seconds(1000)), IsEmpty());
}

TEST(PreviewMessagesTest, TheSameIsSaidOnceAndOnlyTheNewest) {
  PreviewMessages messages;
  messages.tell(seconds(0), "a");
  messages.tell(seconds(3), "a");
  EXPECT_THAT(messages.lines(seconds(6)), ElementsAre("a")) << "told anew, it stays longer";
  for (const char* const text : {"b", "c", "d", "e"}) {
    messages.tell(seconds(6), text);
  }
  EXPECT_THAT(messages.lines(seconds(6)), ElementsAre("b", "c", "d", "e"));
}

}  // namespace

}  // namespace foveola
