#include "renderer/window/screens/panel_layout.h"

#include <algorithm>
#include <array>
#include <optional>

#include "renderer/base/text/utf8.h"
#include "renderer/window/screens/screen_column.h"

namespace foveola {
namespace {

/// A panel's position, as a share of the view's free space.
Vec2 anchor(PanelPlace place) {
  switch (place) {
    case PanelPlace::top_right:
      return {1.0F, 0.0F};
    case PanelPlace::bottom_left:
      return {0.0F, 1.0F};
    case PanelPlace::bottom_right:
      return {1.0F, 1.0F};
    case PanelPlace::upper:
      return {0.5F, 0.2F};
    case PanelPlace::middle:
      return {0.5F, 0.5F};
    case PanelPlace::top_left:
      break;
  }
  return {0.0F, 0.0F};
}

bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// The placed panels, and places for more.
class Places {
 public:
  Places(const ScreenRect& view, const Vec2& letter_px) : view_(view), letter_px_(letter_px) {}

  /// Lines broken to the view's width.
  std::vector<std::string> broken(const std::vector<std::string>& lines) const {
    const float room_px = view_.size().x - 2.0F * (panel_margin_px + panel_padding_px);
    const float width_px = std::max(room_px, letter_px_.x);
    const auto width_of = [this](std::string_view line) {
      return letter_px_.x * static_cast<float>(count_characters(line));
    };
    std::vector<std::string> rows;
    for (const std::string& line : lines) {
      // Columns fit their lines; breaking would remove spaces.
      const auto parts = width_of(line) <= width_px ? std::vector<std::string>{line}
                                                    : wrap_to_width(line, width_px, width_of);
      rows.insert(rows.end(), parts.begin(), parts.end());
    }
    return rows;
  }

  Vec2 size_of(const PlacedPanel& panel) const {
    std::size_t columns = 0;
    for (const std::string& line : panel.lines) {
      columns = std::max(columns, count_characters(line));
    }
    const std::size_t rows = panel.lines.size() + (panel.has_density_scale ? 1 : 0);
    return letter_px_ * Vec2(columns, rows) + 2.0F * panel_padding_px;
  }

  /// The free rectangle of a size nearest to a place, below it or, at the bottom, above.
  std::optional<ScreenRect> free_at(PanelPlace place, const Vec2& size) const {
    const Vec2 room = view_.size() - 2.0F * panel_margin_px - size;
    if (room.x < 0.0F || room.y < 0.0F) {
      return std::nullopt;
    }
    const bool is_at_bottom = anchor(place).y > 0.5F;
    const Vec2 first = view_.low + panel_margin_px + glm::floor(anchor(place) * room);
    std::vector<float> tops = {first.y};
    for (const ScreenRect& one : taken_) {
      tops.push_back(is_at_bottom ? one.low.y - size.y : one.high.y);
    }
    std::ranges::sort(tops);
    if (is_at_bottom) {
      std::ranges::reverse(tops);
    }
    const float low_y = view_.low.y + panel_margin_px;
    for (const float top : tops) {
      const ScreenRect rect{.low = {first.x, top}, .high = Vec2(first.x, top) + size};
      const bool is_on_its_side = is_at_bottom ? top <= first.y : top >= first.y;
      if (is_on_its_side && top >= low_y && top <= low_y + room.y && is_free(rect)) {
        return rect;
      }
    }
    return std::nullopt;
  }

  /// The first free place of a panel, beginning at its own.
  std::optional<ScreenRect> free_for(PanelPlace wanted, const Vec2& size) const {
    constexpr std::array corners = {PanelPlace::top_left, PanelPlace::top_right,
                                    PanelPlace::bottom_left, PanelPlace::bottom_right};
    std::optional<ScreenRect> free = free_at(wanted, size);
    for (std::size_t i = 0; i < corners.size() && !free; ++i) {
      free = free_at(corners[i], size);
    }
    return free;
  }

  void take(const ScreenRect& rect) {
    const Vec2 gap(panel_margin_px);
    taken_.push_back({.low = rect.low - gap, .high = rect.high + gap});
  }

 private:
  bool is_free(const ScreenRect& rect) const {
    return std::ranges::none_of(taken_, [&](const ScreenRect& one) { return overlap(rect, one); });
  }

  ScreenRect view_;
  Vec2 letter_px_;
  std::vector<ScreenRect> taken_;
};

}  // namespace

std::vector<PlacedPanel> lay_out(std::span<const TextPanel> panels, const ScreenRect& view,
                                 const Vec2& letter_px) {
  Places places(view, letter_px);
  std::vector<PlacedPanel> placed;
  for (const TextPanel& panel : panels) {
    PlacedPanel shown{.lines = places.broken(panel.lines),
                      .has_density_scale = panel.has_density_scale};
    std::optional<ScreenRect> rect = places.free_for(panel.place, places.size_of(shown));
    while (!rect && shown.lines.size() > 1) {
      shown.lines.pop_back();
      rect = places.free_for(panel.place, places.size_of(shown));
    }
    if (rect) {
      shown.rect = *rect;
      places.take(*rect);
      placed.push_back(std::move(shown));
    }
  }
  return placed;
}

}  // namespace foveola
