// Lays out panels of text over a picture: side by side, in a window of any size.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/window/screens/screen_layout.h"

namespace foveola {

/// `upper` lies between the central and the corner targets of a tracker check.
enum class PanelPlace { top_left, top_right, bottom_left, bottom_right, upper, middle };

struct TextPanel {
  PanelPlace place = PanelPlace::top_left;
  std::vector<std::string> lines;
  bool has_density_scale = false;  ///< whether the density colours are above the lines
};

/// A panel ready to draw.
struct PlacedPanel {
  ScreenRect rect;
  std::vector<std::string> lines;  ///< one per row of text, from the top
  bool has_density_scale = false;  ///< in the first row, above the lines
};

/// Space between a panel and the window's edges, or another panel.
inline constexpr float panel_margin_px = 8.0F;
/// Space between a panel's edge and its text.
inline constexpr float panel_padding_px = 6.0F;

/// Places panels in `view` in order. A panel is placed beside earlier ones in its corner, or in
/// another corner if that lacks room. If it fits nowhere, its last lines are left out, or all of
/// it. Nothing overlaps. Long lines are broken. letter_px: width and height of every letter.
std::vector<PlacedPanel> lay_out(std::span<const TextPanel> panels, const ScreenRect& view,
                                 const Vec2& letter_px);

}  // namespace foveola
