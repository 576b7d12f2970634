#include "renderer/window/drawing/view_overlays.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

namespace foveola {
namespace {

constexpr Rgb highlight{1.0F, 0.85F, 0.1F};

using Points = std::vector<ImVec2>;

ImU32 im(const Rgb& color, float opacity = 1.0F) {
  return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, opacity});
}

/// A view's part of the window, in the window's pixels from its top left.
struct Pane {
  const Viewport& viewport;
  Vec2 low;
  Vec2 size;

  Vec2 high() const { return low + size; }
  ImVec2 at(const Vec2& plane) const {
    const Vec2 place = low + plane * size;
    return {place.x, place.y};
  }
  /// nullopt for a direction outside the view.
  std::optional<ImVec2> project(const Vec3& direction) const {
    const std::optional<Vec2> plane = viewport.project(direction);
    return plane ? std::optional(at(*plane)) : std::nullopt;
  }
  /// The angle of a pixel in the centre of a view without a lens.
  float pixel_rad() const { return 2.0F * viewport.half_size().x / size.x; }
};

/// The directions at an angle from a centre. Turns grow clockwise in the view, as Dear ImGui
/// requires of filled outlines.
class Circle {
 public:
  Circle(const Vec3& middle, float radius_rad) : frame_(middle), radius_rad_(radius_rad) {}

  Vec3 direction(float turn_rad) const {
    const float away = std::sin(radius_rad_);
    return frame_.to_world(
        {away * std::cos(turn_rad), away * std::sin(turn_rad), std::cos(radius_rad_)});
  }

 private:
  Frame frame_;
  float radius_rad_;
};

/// The visible part of a circle: all of it, or arcs from edge to edge.
struct ShownCircle {
  std::vector<Points> arcs;
  bool is_whole = false;
};

/// The last visible place of the circle between a visible and an invisible turn.
ImVec2 last_seen(const Circle& circle, const Pane& pane, float seen_rad, float unseen_rad) {
  constexpr int halvings = 12;
  ImVec2 last = *pane.project(circle.direction(seen_rad));
  for (int i = 0; i < halvings; ++i) {
    const float between_rad = 0.5F * (seen_rad + unseen_rad);
    const std::optional<ImVec2> place = pane.project(circle.direction(between_rad));
    (place ? seen_rad : unseen_rad) = between_rad;
    last = place.value_or(last);
  }
  return last;
}

ShownCircle shown_circle(const Circle& circle, const Pane& pane, int steps) {
  const auto turn_rad = [steps](int step) {
    return 2.0F * std::numbers::pi_v<float> * static_cast<float>(step) / static_cast<float>(steps);
  };
  std::vector<std::optional<ImVec2>> places;
  for (int step = 0; step < steps; ++step) {
    places.push_back(pane.project(circle.direction(turn_rad(step))));
  }
  const auto unseen = std::find(places.begin(), places.end(), std::nullopt);
  ShownCircle shown{.is_whole = unseen == places.end()};
  // A circle cut by no edge begins anywhere; others begin after an invisible place.
  const auto first = shown.is_whole ? 0 : static_cast<int>(unseen - places.begin());
  bool was_seen = false;
  for (int step = first; step < first + steps; ++step) {
    const std::optional<ImVec2>& place = places[static_cast<std::size_t>(step % steps)];
    if (place && !was_seen) {
      shown.arcs.emplace_back();
      if (!shown.is_whole) {
        shown.arcs.back().push_back(last_seen(circle, pane, turn_rad(step), turn_rad(step - 1)));
      }
    }
    if (place) {
      shown.arcs.back().push_back(*place);
    } else if (was_seen) {
      shown.arcs.back().push_back(last_seen(circle, pane, turn_rad(step - 1), turn_rad(step)));
    }
    was_seen = place.has_value();
  }
  if (was_seen && !shown.is_whole) {
    const int end = first + steps;
    shown.arcs.back().push_back(last_seen(circle, pane, turn_rad(end - 1), turn_rad(end)));
  }
  return shown;
}

ShownCircle shown_ring(const Vec3& middle, float radius_rad, const Pane& pane) {
  constexpr int steps = 256;
  return shown_circle(Circle(middle, radius_rad), pane, steps);
}

/// A place at this distance beyond `end`, on the line from `before`.
ImVec2 beyond(const ImVec2& before, const ImVec2& end, float distance_px) {
  const Vec2 along(end.x - before.x, end.y - before.y);
  const float length_px = glm::length(along);
  const Vec2 step = length_px > 0.0F ? along * (distance_px / length_px) : Vec2(0.0F);
  return {end.x + step.x, end.y + step.y};
}

/// An arc is extended beyond the edges that cut it, so that its square ends lie outside.
void paint_line(ImDrawList& list, const ShownCircle& circle, ImU32 color, float width_px) {
  for (Points arc : circle.arcs) {
    if (!circle.is_whole) {
      arc.insert(arc.begin(), beyond(arc[1], arc[0], width_px));
      arc.push_back(beyond(arc[arc.size() - 2], arc.back(), width_px));
    }
    list.AddPolyline(arc.data(), static_cast<int>(arc.size()), color,
                     circle.is_whole ? ImDrawFlags_Closed : ImDrawFlags_None, width_px);
  }
}

/// Where an edge cuts it, its rim goes straight from one end of an arc to the next.
void paint_disc(ImDrawList& list, const Vec3& middle, float radius_rad, const Pane& pane,
                ImU32 color) {
  constexpr int steps = 48;
  Points rim;
  for (const Points& arc : shown_circle(Circle(middle, radius_rad), pane, steps).arcs) {
    rim.insert(rim.end(), arc.begin(), arc.end());
  }
  list.AddConvexPolyFilled(rim.data(), static_cast<int>(rim.size()), color);
}

/// The same few pixels everywhere.
void paint_point(ImDrawList& list, const Vec3& direction, const Pane& pane, ImU32 color) {
  constexpr float radius_px = 5.0F;
  if (const std::optional<ImVec2> middle = pane.project(direction)) {
    list.AddCircleFilled(*middle, radius_px, color);
  }
}

/// Colours are interpolated between the centres of four cells, and constant beyond the outermost
/// ones.
void paint_densities(ImDrawList& list, const DensityMap& map, const Pane& pane) {
  constexpr float opacity = 0.45F;
  const Vec2 cells(map.width, map.height);
  const auto corner = [&](int x, int y) {
    return pane.at(glm::clamp((Vec2(x, y) + 0.5F) / cells, 0.0F, 1.0F));
  };
  const auto color = [&](int x, int y) {
    const int column = std::clamp(x, 0, map.width - 1);
    const int row = std::clamp(y, 0, map.height - 1);
    return im(density_color(map.values[static_cast<std::size_t>(row * map.width + column)]),
              opacity);
  };
  for (int y = -1; y < map.height; ++y) {
    for (int x = -1; x < map.width; ++x) {
      list.AddRectFilledMultiColor(corner(x, y), corner(x + 1, y + 1), color(x, y), color(x + 1, y),
                                   color(x + 1, y + 1), color(x, y + 1));
    }
  }
}

/// The ring's eccentricity in degrees, above its topmost place.
void paint_label(ImDrawList& list, const ShownCircle& ring, float radius_rad, const Pane& pane) {
  constexpr float margin_px = 2.0F;
  if (ring.arcs.empty()) {
    return;
  }
  ImVec2 top = ring.arcs.front().front();
  for (const Points& arc : ring.arcs) {
    for (const ImVec2& place : arc) {
      top = place.y < top.y ? place : top;
    }
  }
  const std::string text = fmt::format("{:.3g}°", degrees(radius_rad));
  const ImVec2 wanted = ImGui::CalcTextSize(text.c_str());
  const Vec2 size = Vec2(wanted.x, wanted.y) + 2.0F * margin_px;
  const Vec2 low = glm::clamp(Vec2(top.x - 0.5F * size.x, top.y - size.y), pane.low,
                              glm::max(pane.low, pane.high() - size));
  const Vec2 high = low + size;
  list.AddRectFilled({low.x, low.y}, {high.x, high.y}, im(Rgb(0.0F), 0.6F));
  list.AddText({low.x + margin_px, low.y + margin_px}, im(Rgb(1.0F, 0.8F, 0.1F)), text.c_str());
}

void paint_rings(ImDrawList& list, const ViewOverlays& overlays, const Pane& pane) {
  for (const float radius_rad : overlays.rings_rad) {
    const ShownCircle ring = shown_ring(overlays.gaze, radius_rad, pane);
    paint_line(list, ring, im(Rgb(1.0F, 0.8F, 0.1F), 0.8F), 1.5F);
    paint_label(list, ring, radius_rad, pane);
  }
}

/// White on black is visible on any picture; the highlighted one also differs by its width.
void paint_offer(ImDrawList& list, const OfferRing& offer, const Pane& pane) {
  const float width_px = offer.is_highlighted ? 6.0F : 2.0F;
  const Rgb ink = offer.is_highlighted ? highlight : Rgb(1.0F);
  const ShownCircle ring = shown_ring(offer.direction, offer.radius_rad, pane);
  paint_line(list, ring, im(Rgb(0.0F)), width_px + 4.0F);
  paint_line(list, ring, im(ink), width_px);
}

/// From the view's centre towards a direction outside the view, as long as a sixth of its shorter
/// side: near the centre, since a lens shows little of the edges. A direction exactly behind is to
/// the right.
void paint_arrow(ImDrawList& list, const Vec3& direction, const Pane& pane) {
  const Vec3 in_head = glm::inverse(pane.viewport.head()) * direction;
  const Vec2 aside(in_head.x, -in_head.y);
  const float length = glm::length(aside);
  const Vec2 along = length > 1e-6F ? aside / length : Vec2(1.0F, 0.0F);
  const Vec2 across(-along.y, along.x);
  const float unit_px = std::min(pane.size.x, pane.size.y) / 6.0F;
  const Vec2 tail = 0.5F * (pane.low + pane.high()) + 0.75F * unit_px * along;
  const Vec2 tip = tail + unit_px * along;
  const Vec2 neck = tip - 0.4F * unit_px * along;
  const auto draw = [&](ImU32 color, float grown_px) {
    const Vec2 end = tail - grown_px * along;
    const Vec2 wing = (0.25F * unit_px + 2.0F * grown_px) * across;
    const Vec2 root = neck - grown_px * along;
    const Vec2 point = tip + 2.0F * grown_px * along;
    list.AddLine({end.x, end.y}, {neck.x, neck.y}, color, 0.12F * unit_px + 2.0F * grown_px);
    list.AddTriangleFilled({point.x, point.y}, {root.x + wing.x, root.y + wing.y},
                           {root.x - wing.x, root.y - wing.y}, color);
  };
  draw(im(Rgb(0.0F)), 2.0F);
  draw(im(highlight), 0.0F);
}

/// A bull's eye draws the gaze to its centre (Thaler et al. 2013, "What is the best fixation
/// target?"): a disc of 0.6 degrees' diameter, in it one of 0.2, on grey.
void paint_target(ImDrawList& list, const Vec3& target, float least_px, const Pane& pane) {
  const float radius_rad = std::max(static_cast<float>(radians(0.3)), least_px * pane.pixel_rad());
  list.AddRectFilled({pane.low.x, pane.low.y}, {pane.high().x, pane.high().y}, im(Rgb(0.5F)));
  paint_disc(list, target, radius_rad, pane, im(Rgb(0.0F)));
  paint_disc(list, target, radius_rad / 3.0F, pane, im(Rgb(1.0F)));
}

}  // namespace

void paint(ImDrawList& list, const ViewOverlays& overlays, const ShownView& view,
           int framebuffer_height) {
  const IVec2 low(view.part.origin.x, framebuffer_height - view.part.origin.y - view.part.size.y);
  const Pane pane{.viewport = view.viewport, .low = Vec2(low), .size = Vec2(view.part.size)};
  list.PushClipRect({pane.low.x, pane.low.y}, {pane.high().x, pane.high().y});
  if (overlays.density) {
    paint_densities(list, *overlays.density, pane);
  }
  paint_rings(list, overlays, pane);
  for (const OfferRing& offer : overlays.offers) {
    paint_offer(list, offer, pane);
    if (offer.is_highlighted && !pane.viewport.project(offer.direction)) {
      paint_arrow(list, offer.direction, pane);
    }
  }
  if (overlays.shows_gaze) {
    paint_point(list, overlays.gaze, pane, im(Rgb(1.0F, 0.1F, 0.2F), 0.9F));
  }
  if (overlays.target) {
    paint_target(list, *overlays.target, overlays.min_target_px, pane);
  }
  list.PopClipRect();
}

DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width,
                       int height) {
  constexpr double decades = 2.0;
  constexpr double uniform = 0.25 * std::numbers::inv_pi;
  DensityMap map{.width = width, .height = height};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec2 plane = (Vec2(x, y) + 0.5F) / Vec2(width, height);
      const double density = sampler.density_per_sr(viewport.direction(plane)) / uniform;
      const double shown = density > 0.0 ? 0.5 + 0.5 * std::log10(density) / decades : 0.0;
      map.values.push_back(static_cast<float>(std::clamp(shown, 0.0, 1.0)));
    }
  }
  return map;
}

Rgb density_color(float value) {
  const Rgb color(3.0F * value - 1.0F, 1.5F - std::abs(3.0F * value - 1.5F), 2.0F - 3.0F * value);
  return glm::clamp(color, 0.0F, 1.0F);
}

}  // namespace foveola
