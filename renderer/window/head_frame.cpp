#include "renderer/window/head_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace foveola {
namespace {

/// The view of the same head, wider by so much on each side, without a lens' distortion.
Viewport widened(const Viewport& view, double by_rad) {
  constexpr double farthest_rad = radians(85.0);
  const auto side = [&](double tangent) {
    return std::tan(std::min(std::atan(tangent) + by_rad, farthest_rad));
  };
  const DVec2 low = 2.0 * DVec2(view.lens().axis) * DVec2(view.half_size());
  const DVec2 high = 2.0 * DVec2(view.half_size()) - low;
  const DVec2 wide_low(side(low.x), side(low.y));
  const DVec2 size = wide_low + DVec2(side(high.x), side(high.y));
  return {view.head(),
          2.0 * std::atan(0.5 * size.x),
          2.0 * std::atan(0.5 * size.y),
          {.axis = Vec2(wide_low / size)}};
}

}  // namespace

ShownFrame head_frame(const WindowArea& window, const ViewGeometry& geometry, const Quat& head,
                      const ViewLook& look) {
  ShownFrame frame{.framebuffer = window.is_seen() ? window.framebuffer : IVec2(0), .look = look};
  const std::vector<Viewport> viewports = viewports_of(geometry, head);
  for (std::size_t i = 0; i < viewports.size(); ++i) {
    frame.views.push_back({.viewport = viewports[i], .part = geometry.parts[i]});
    if (viewports.size() > 1) {
      frame.views.back().straight_ahead = viewports[i].lens().axis;
    }
  }
  return frame;
}

FilmUpdate update_for(const ShownFrame& frame, const EquirectFilm& film, FilmMirror& mirror) {
  std::vector<Viewport> viewports;
  for (const ShownView& view : frame.views) {
    viewports.push_back(frame.late_turn_rad > 0.0 ? widened(view.viewport, frame.late_turn_rad)
                                                  : view.viewport);
  }
  const int levels = frame.look.fill_unsampled
                         ? film.levels()
                         : levels_shown(frame.views.front().viewport, frame.views.front().part.size,
                                        film.height());
  return mirror.collect(film, viewports, levels);
}

}  // namespace foveola
