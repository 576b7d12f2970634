// Where the panels of text over a picture stand: beside each other, however small the window is.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/window/screens/screen_layout.h"

namespace foveola {

/// `upper` lies between the targets in the middle and in the corners of a check of the tracker.
enum class PanelPlace { top_left, top_right, bottom_left, bottom_right, upper, middle };

struct TextPanel {
  PanelPlace place = PanelPlace::top_left;
  std::vector<std::string> lines;
  bool has_density_scale = false;  ///< whether the colours of densities stand above the lines
};

/// A panel as it is drawn.
struct PlacedPanel {
  ScreenRect rect;
  std::vector<std::string> lines;  ///< one a row of text, from the top
  bool has_density_scale = false;  ///< the first row, below which the lines follow
};

/// Space between a panel and the window's edges, or another panel.
inline constexpr float panel_margin_px = 8.0F;
/// Space between a panel's edge and its text.
inline constexpr float panel_padding_px = 6.0F;

/// Places panels in `view`, the first ones first. One stands beside those before it in its corner,
/// or in another corner if it has no room there; if it fits nowhere, its last lines are left out,
/// and so is all of it where there is no room for a line. Nothing overlaps. Long lines are broken.
/// letter_px: width and height of every letter.
std::vector<PlacedPanel> lay_out(std::span<const TextPanel> panels, const ScreenRect& view,
                                 const Vec2& letter_px);

}  // namespace foveola
