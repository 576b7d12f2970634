#include "renderer/window/live/free_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "renderer/base/numbers/quantile.h"
#include "renderer/progressive/picture.h"
#include "renderer/view/viewport.h"
#include "renderer/window/live/steering.h"

namespace foveola {
namespace {

/// Hands shake: a shorter way is a click.
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

struct MovingKey {
  int key;
  enum class When { always, with_shift, in_flight } when;
  Vec3 way;  ///< right, up, and forward
};

constexpr std::array moving_keys = {
    MovingKey{GLFW_KEY_UP, MovingKey::When::with_shift, {0, 0, 1}},
    MovingKey{GLFW_KEY_DOWN, MovingKey::When::with_shift, {0, 0, -1}},
    MovingKey{GLFW_KEY_RIGHT, MovingKey::When::with_shift, {1, 0, 0}},
    MovingKey{GLFW_KEY_LEFT, MovingKey::When::with_shift, {-1, 0, 0}},
    MovingKey{GLFW_KEY_PAGE_UP, MovingKey::When::always, {0, 1, 0}},
    MovingKey{GLFW_KEY_PAGE_DOWN, MovingKey::When::always, {0, -1, 0}},
    MovingKey{GLFW_KEY_W, MovingKey::When::in_flight, {0, 0, 1}},
    MovingKey{GLFW_KEY_S, MovingKey::When::in_flight, {0, 0, -1}},
    MovingKey{GLFW_KEY_D, MovingKey::When::in_flight, {1, 0, 0}},
    MovingKey{GLFW_KEY_A, MovingKey::When::in_flight, {-1, 0, 0}},
    MovingKey{GLFW_KEY_E, MovingKey::When::in_flight, {0, 1, 0}},
    MovingKey{GLFW_KEY_Q, MovingKey::When::in_flight, {0, -1, 0}},
};

constexpr std::array modifier_keys = {GLFW_KEY_LEFT_SHIFT,   GLFW_KEY_RIGHT_SHIFT,
                                      GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL,
                                      GLFW_KEY_LEFT_ALT,     GLFW_KEY_RIGHT_ALT};

const MovingKey* moving_key(int key) {
  const auto found = std::ranges::find(moving_keys, key, &MovingKey::key);
  return found != moving_keys.end() ? &*found : nullptr;
}

bool holds(const std::set<int>& held, int left, int right) {
  return held.contains(left) || held.contains(right);
}

/// Width of the space around the camera: twice the median distance in the directions of a cube's
/// sides, edges and corners. At most the scene's diagonal, also if most of them hit nothing: a room
/// is walked through as a room, whatever lies outside.
double width_around(const CameraSurroundings& surroundings) {
  std::vector<double> distances_m;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        if (x != 0 || y != 0 || z != 0) {
          const std::optional<Sighted> seen =
              surroundings.look(surroundings.start.position, glm::normalize(Vec3(x, y, z)));
          distances_m.push_back(seen ? seen->distance_m : std::numeric_limits<double>::infinity());
        }
      }
    }
  }
  const Bounds& all = surroundings.bounds;
  return std::min(2.0 * upper_median(std::move(distances_m)).value(),
                  glm::distance(DVec3(all.lower), DVec3(all.upper)));
}

std::string words_of(const std::optional<Sighted>& seen) {
  return seen ? fmt::format("'{}' of '{}', {:.3g} m away", seen->object, seen->material,
                            seen->distance_m)
              : "nothing is there";
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

FreeCamera::FreeCamera(CameraSurroundings surroundings, HeadTracker& shown,
                       SteeredHeadTracker* steered, std::string turned_by)
    : surroundings_(std::move(surroundings)),
      head_(&shown),
      steered_head_(steered),
      turned_by_(std::move(turned_by)),
      position_(surroundings_.start.position),
      first_speed_m_per_s_(walking_speed(width_around(surroundings_))),
      speed_m_per_s_(first_speed_m_per_s_) {}

void FreeCamera::move_into(CameraSurroundings surroundings) {
  const Vec3 shift(surroundings_.origin - surroundings.origin);
  surroundings_ = std::move(surroundings);
  position_ += shift;
  pivot_ += shift;
  picked_.reset();  // it may be gone, or have another size
}

void FreeCamera::show(const ViewGeometry& geometry, const IVec2& framebuffer,
                      double pixels_per_unit) {
  geometry_ = geometry;
  framebuffer_ = framebuffer;
  mouse_.show(pixels_per_unit);
}

bool FreeCamera::follow(const WindowEvent& event) {
  return std::visit(
      [&](const auto& what) {
        if constexpr (requires { this->steer(event.time, what); }) {
          return this->steer(event.time, what);
        }
        return false;
      },
      event.what);
}

bool FreeCamera::moves_while_held(int key) const {
  const MovingKey* const moving = moving_key(key);
  if (moving == nullptr) {
    return false;
  }
  switch (moving->when) {
    case MovingKey::When::with_shift:
      return holds(modifiers_, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    case MovingKey::When::in_flight:
      return mouse_.drag() == Drag::fly;
    case MovingKey::When::always:
      break;
  }
  return true;
}

bool FreeCamera::steer(Nanoseconds time, const KeyMoved& key) {
  if (std::ranges::find(modifier_keys, key.key) != modifier_keys.end()) {
    key.is_down ? void(modifiers_.insert(key.key)) : void(modifiers_.erase(key.key));
    return false;
  }
  if (key.is_down && moves_while_held(key.key)) {
    walk_until(time);
    held_.insert(key.key);
    return true;
  }
  if (!key.is_down && held_.contains(key.key)) {
    walk_until(time);
    held_.erase(key.key);
  }
  return key.is_down && TurnKeys().follow(key) && !can_turn();
}

/// In flight letters only move the camera.
bool FreeCamera::steer(Nanoseconds /*time*/, const CharacterTyped& /*typed*/) const {
  return mouse_.drag() == Drag::fly;
}

bool FreeCamera::steer(Nanoseconds time, const WheelTurned& wheel) {
  constexpr double step = 1.25;
  constexpr double max_times = 1000.0;  // relative to the initial speed
  if (!holds(modifiers_, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL)) {
    return false;
  }
  walk_until(time);
  speed_m_per_s_ = std::clamp(speed_m_per_s_ * std::pow(step, wheel.away),
                              first_speed_m_per_s_ / max_times, first_speed_m_per_s_ * max_times);
  note_ = fmt::format("speed {:.3g} m/s", speed_m_per_s_);
  return true;
}

bool FreeCamera::steer(Nanoseconds time, const MouseButtonMoved& button) {
  const bool holds_alt = holds(modifiers_, GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  const Drag before = mouse_.drag();
  if (const std::optional<DVec2> click = mouse_.follow(button, holds_alt)) {
    look_at(time, *click);
  }
  if (before == Drag::fly && mouse_.drag() == Drag::none) {
    walk_until(time);
    std::erase_if(held_,
                  [](int key) { return moving_key(key)->when == MovingKey::When::in_flight; });
  }
  if (before == Drag::none && mouse_.drag() == Drag::orbit && can_turn()) {
    const Standing now = standing(time);
    const std::optional<Sighted> ahead =
        picked_ ? picked_ : surroundings_.look(now.position, direction_from(now.heading));
    pivot_ =
        ahead ? ahead->position : 0.5F * (surroundings_.bounds.lower + surroundings_.bounds.upper);
  }
  return mouse_.drag() == Drag::orbit || before == Drag::orbit;
}

bool FreeCamera::steer(Nanoseconds time, const PointerMoved& moved) {
  const DVec2 way_px = mouse_.follow(moved);
  if (way_px == DVec2(0.0) || !can_turn()) {
    return false;
  }
  if (mouse_.drag() == Drag::orbit) {
    orbit(time, way_px);
  } else if (mouse_.drag() == Drag::fly) {
    steered_head_->turn(time, turn_of_drag(geometry_, way_px));
  }
  return false;
}

bool FreeCamera::steer(Nanoseconds /*time*/, const GamepadMoved& gamepad) {
  const TurnSpeed speed = turn_speed(gamepad.sticks, StickResponse{});
  return (speed.right_rad_per_s != 0.0 || speed.up_rad_per_s != 0.0) && !can_turn();
}

bool FreeCamera::can_turn() {
  if (steered_head_ == nullptr) {
    note_ = turned_by_ + " turns the head: keys and mouse only move the camera";
  }
  return steered_head_ != nullptr;
}

void FreeCamera::look_at(Nanoseconds time, const DVec2& place_px) {
  const Standing now = standing(time);
  const Vec3 direction = glm::normalize(head_->pose(time).orientation() *
                                        direction_below(geometry_, place_px, framebuffer_.y));
  const std::optional<Sighted> seen = surroundings_.look(now.position, direction);
  picked_ = seen ? seen : picked_;
  note_ = words_of(seen);
  stand(time, {.position = now.position, .heading = azimuth_elevation(direction)});
}

void FreeCamera::orbit(Nanoseconds time, const DVec2& way_px) {
  constexpr double across_rad = radians(180.0);  // for a drag across the window
  const double rad_per_pixel = across_rad / std::max(1, framebuffer_.x);
  stand(time,
        orbited(standing(time), pivot_,
                {.right_rad = rad_per_pixel * way_px.x, .up_rad = -rad_per_pixel * way_px.y}));
}

void FreeCamera::fit(Nanoseconds now) {
  const Bounds& bounds = picked_ ? picked_->bounds : surroundings_.bounds;
  if (bounds.lower == bounds.upper) {
    note_ = "there is nothing to fit to the view";
    return;
  }
  const AzimuthElevation heading = standing(now).heading;
  Framing framing(heading, {.horizontal_deg = geometry_.horizontal_fov_deg,
                            .vertical_deg = geometry_.vertical_fov_deg});
  framing.include(bounds);
  stand(now, {.position = framing.position(), .heading = heading});
  note_ = picked_ ? fmt::format("'{}' fits the view", picked_->object) : "all fits the view";
}

void FreeCamera::go_back(Nanoseconds now) {
  picked_.reset();
  stand(now, surroundings_.start);
}

void FreeCamera::bring(Nanoseconds now, const Vec3& from, const Vec3& to) {
  if (steered_head_ == nullptr) {
    return;
  }
  const Quat head = head_->pose(now).orientation();
  const AzimuthElevation seen = azimuth_elevation(head * from);
  const AzimuthElevation wanted = azimuth_elevation(head * to);
  steered_head_->turn(now, {.right_rad = wrapped_angle(seen.azimuth_rad - wanted.azimuth_rad),
                            .up_rad = seen.elevation_rad - wanted.elevation_rad});
}

Standing FreeCamera::standing(Nanoseconds time) {
  walk_until(time);
  return {.position = position_, .heading = head_->pose(time).heading};
}

void FreeCamera::stand(Nanoseconds time, const Standing& standing) {
  position_ = standing.position;
  if (steered_head_ != nullptr) {
    const AzimuthElevation before = head_->pose(time).heading;
    steered_head_->turn(time, {.right_rad = standing.heading.azimuth_rad - before.azimuth_rad,
                               .up_rad = standing.heading.elevation_rad - before.elevation_rad});
  }
}

void FreeCamera::walk_until(Nanoseconds now) {
  const Nanoseconds took = std::max(Nanoseconds(0), now - since_);
  since_ = std::max(since_, now);
  if (!held_.empty()) {
    const Quat head = head_->pose(now).orientation();
    position_ += static_cast<float>(seconds(took)) * velocity(head);
  }
}

Vec3 FreeCamera::velocity(const Quat& head) const {
  Vec3 way(0.0F);
  for (const int key : held_) {
    way += moving_key(key)->way;
  }
  const Vec3 world = head * Vec3(way.x, 0.0F, -way.z) + Vec3(0.0F, way.y, 0.0F);
  return static_cast<float>(speed_m_per_s_) * world;
}

}  // namespace foveola
