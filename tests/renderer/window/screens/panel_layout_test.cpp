#include "renderer/window/screens/panel_layout.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

constexpr Vec2 letter_px(7.0F, 13.0F);

TextPanel panel(PanelPlace place, std::size_t lines, std::size_t columns) {
  return {.place = place, .lines = std::vector<std::string>(lines, std::string(columns, 'a'))};
}

ScreenRect view(float width, float height) { return {.low = Vec2(0.0F), .high = {width, height}}; }

bool overlap(const PlacedPanel& a, const PlacedPanel& b) {
  return a.rect.low.x < b.rect.high.x && b.rect.low.x < a.rect.high.x &&
         a.rect.low.y < b.rect.high.y && b.rect.low.y < a.rect.high.y;
}

/// All that the live preview can show at a time, and more.
std::vector<TextPanel> everything() {
  return {panel(PanelPlace::bottom_left, 3, 60), panel(PanelPlace::middle, 19, 76),
          panel(PanelPlace::top_left, 8, 40),    panel(PanelPlace::top_right, 9, 50),
          panel(PanelPlace::top_left, 5, 70),    panel(PanelPlace::bottom_right, 3, 42)};
}

TEST(PanelLayoutTest, NothingOverlapsAndAllIsInside) {
  const std::vector<TextPanel> panels = everything();
  for (const Vec2& size : {Vec2(800, 450), Vec2(1280, 720), Vec2(1920, 1080), Vec2(200, 160),
                           Vec2(100, 60), Vec2(2, 1)}) {
    const std::vector<PlacedPanel> placed = lay_out(panels, view(size.x, size.y), letter_px);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const ScreenRect& rect = placed[i].rect;
      EXPECT_TRUE(rect.low.x >= 0.0F && rect.low.y >= 0.0F && rect.high.x <= size.x &&
                  rect.high.y <= size.y)
          << size.x << ", panel " << i;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(overlap(placed[i], placed[k])) << size.x << ": " << k << " and " << i;
      }
    }
  }
}

TEST(PanelLayoutTest, ALargeWindowHasRoomForAll) {
  const std::vector<TextPanel> panels = everything();
  const std::vector<PlacedPanel> placed = lay_out(panels, view(1920, 1080), letter_px);
  ASSERT_THAT(placed, SizeIs(panels.size()));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    EXPECT_EQ(placed[i].lines, panels[i].lines) << i;
  }
}

TEST(PanelLayoutTest, PanelsStandInTheirCorners) {
  const std::vector<TextPanel> panels = {
      panel(PanelPlace::top_left, 1, 10), panel(PanelPlace::top_left, 1, 10),
      panel(PanelPlace::bottom_right, 1, 10), panel(PanelPlace::upper, 1, 10)};
  const std::vector<PlacedPanel> placed = lay_out(panels, view(800, 450), letter_px);
  ASSERT_THAT(placed, SizeIs(4));
  EXPECT_EQ(placed[0].rect.low, Vec2(8.0F, 8.0F));
  EXPECT_EQ(placed[0].rect.size(), Vec2(82.0F, 25.0F));  // letters and 6 pixels all around
  EXPECT_EQ(placed[1].rect.low, Vec2(8.0F, 41.0F));
  EXPECT_EQ(placed[2].rect.high, Vec2(792.0F, 442.0F));
  EXPECT_EQ(placed[3].rect.low, Vec2(359.0F, 89.0F));
}

TEST(PanelLayoutTest, TheImportantOnesHaveRoomFirst) {
  const std::vector<TextPanel> panels = {panel(PanelPlace::top_left, 2, 10),
                                         panel(PanelPlace::top_left, 9, 10)};
  // Room for 25 + 8 + 38 pixels below each other, and for one column of panels.
  const std::vector<PlacedPanel> placed = lay_out(panels, view(120, 112), letter_px);
  ASSERT_THAT(placed, SizeIs(2));
  EXPECT_THAT(placed[0].lines, SizeIs(2));
  EXPECT_THAT(placed[1].lines, SizeIs(2)) << "the other seven are left out";
  EXPECT_THAT(lay_out(panels, view(120, 55), letter_px), SizeIs(1));
  EXPECT_THAT(lay_out(panels, view(120, 20), letter_px), IsEmpty());
}

TEST(PanelLayoutTest, LongLinesAreBroken) {
  const std::vector<TextPanel> panels = {{.lines = {"the monitor was lost, and found"}}};
  const std::vector<PlacedPanel> placed = lay_out(panels, view(28 + 7 * 21, 200), letter_px);
  ASSERT_THAT(placed, SizeIs(1));
  EXPECT_THAT(placed[0].lines, ElementsAre("the monitor was lost,", "and found"));
}

TEST(PanelLayoutTest, LettersAreNotBytes) {
  const std::vector<TextPanel> panels = {{.lines = {"5.79°"}}};
  const std::vector<PlacedPanel> placed = lay_out(panels, view(200, 200), letter_px);
  EXPECT_EQ(placed[0].rect.size().x, 5.0F * 7.0F + 12.0F);
}

TEST(PanelLayoutTest, AScaleTakesARow) {
  const std::vector<TextPanel> panels = {{.lines = {"1"}, .has_density_scale = true}};
  const std::vector<PlacedPanel> placed = lay_out(panels, view(200, 200), letter_px);
  EXPECT_EQ(placed[0].rect.size().y, 2.0F * 13.0F + 12.0F);
  EXPECT_TRUE(placed[0].has_density_scale);
}

}  // namespace
}  // namespace foveola
