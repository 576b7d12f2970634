#include "renderer/window/mouse_drags.h"

#include <algorithm>
#include <numbers>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "renderer/view/viewport.h"

namespace foveola {
namespace {

/// Hands shake: what goes no farther is a click.
constexpr double click_way_px = 4.0;

Drag drag_of(int button, bool holds_alt) {
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      return holds_alt ? Drag::orbit : Drag::turn;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return Drag::orbit;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Drag::fly;
    default:
      return Drag::none;
  }
}

}  // namespace

DVec2 MouseDrags::follow(const PointerMoved& moved) {
  const std::optional<DVec2> before = pointer_;
  pointer_ = moved.is_inside ? std::optional(pixels_per_unit_ * moved.position) : std::nullopt;
  if (drag_ == Drag::none || !before || !pointer_) {
    return DVec2(0.0);
  }
  const DVec2 way = *pointer_ - *before;
  way_px_ += glm::length(way);
  return way;
}

std::optional<DVec2> MouseDrags::follow(const MouseButtonMoved& button, bool holds_alt) {
  if (button.is_down && drag_ == Drag::none) {
    drag_ = drag_of(button.button, holds_alt);
    button_ = button.button;
    way_px_ = 0.0;
  } else if (!button.is_down && button.button == button_) {
    const bool is_click = drag_ == Drag::turn && way_px_ < click_way_px;
    drag_ = Drag::none;
    return is_click ? pointer_ : std::nullopt;
  }
  return std::nullopt;
}

Standing orbited(const Standing& standing, const Vec3& pivot, const Turn& turn) {
  constexpr double zenith_rad = 0.5 * std::numbers::pi;
  const AzimuthElevation heading{
      .azimuth_rad = wrapped_angle(standing.heading.azimuth_rad + turn.right_rad),
      .elevation_rad =
          std::clamp(standing.heading.elevation_rad + turn.up_rad, -zenith_rad, zenith_rad)};
  const Vec3 in_head =
      glm::conjugate(head_orientation(standing.heading)) * (pivot - standing.position);
  return {.position = pivot - head_orientation(heading) * in_head, .heading = heading};
}

double walking_speed(double width_m) {
  constexpr double crossing_s = 10.0;
  return width_m > 0.0 ? width_m / crossing_s : 1.0;
}

}  // namespace foveola
