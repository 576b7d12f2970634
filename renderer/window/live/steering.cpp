#include "renderer/window/live/steering.h"

namespace foveola {
namespace {

/// Turning speed of the head by a held key.
constexpr double key_speed_rad_per_s = radians(60.0);

}  // namespace

Turn turn_of_drag(const ViewGeometry& geometry, const DVec2& way_px) {
  const double rad_per_pixel = radians(geometry.horizontal_fov_deg) / geometry.parts.front().size.x;
  return {.right_rad = -rad_per_pixel * way_px.x, .up_rad = rad_per_pixel * way_px.y};
}

void Steering::show(const ViewGeometry& geometry, const IVec2& framebuffer,
                    double pixels_per_unit) {
  geometry_ = geometry;
  framebuffer_ = framebuffer;
  pixels_per_unit_ = pixels_per_unit;
}

void Steering::follow(const WindowEvent& event) {
  std::visit(
      [&](const auto& what) {
        if constexpr (requires { this->steer(event.time, what); }) {
          this->steer(event.time, what);
        }
      },
      event.what);
}

std::optional<Vec3> Steering::pointer() const {
  return pointer_ ? std::optional(direction_below(geometry_, *pointer_, framebuffer_.y))
                  : std::nullopt;
}

void Steering::steer(Nanoseconds time, const KeyMoved& key) {
  if (keys_.follow(key)) {
    turn_at_speed(time);
  }
}

void Steering::steer(Nanoseconds time, const GamepadMoved& gamepad) {
  sticks_ = gamepad.sticks;
  turn_at_speed(time);
}

void Steering::turn_at_speed(Nanoseconds time) {
  TurnSpeed speed = turn_speed(sticks_, StickResponse{});
  speed.right_rad_per_s += key_speed_rad_per_s * keys_.right();
  speed.up_rad_per_s += key_speed_rad_per_s * keys_.up();
  head_->set_speed(time, speed);
}

void Steering::steer(Nanoseconds /*time*/, const MouseButtonMoved& button) {
  constexpr int left_button = 0;
  if (button.button == left_button) {
    is_dragging_ = button.is_down;
  }
}

void Steering::steer(Nanoseconds time, const PointerMoved& moved) {
  const std::optional<DVec2> before = pointer_;
  pointer_ = moved.is_inside ? std::optional(pixels_per_unit_ * moved.position) : std::nullopt;
  if (pointer_gaze_ != nullptr) {
    pointer_gaze_->point_at(time, pointer());
  }
  if (is_dragging_ && before && pointer_) {
    head_->turn(time, turn_of_drag(geometry_, *pointer_ - *before));
  }
}

}  // namespace foveola
