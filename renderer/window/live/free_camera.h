// A camera moved by the user: walking and flying by keys, orbiting picked points by the mouse, and
// flying to clicked ones.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/scene/scene.h"
#include "renderer/window/drawing/view_geometry.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// The effect of moving the mouse, by the held button.
enum class Drag {
  none,
  turn,   ///< left button
  orbit,  ///< middle button, or left one with Alt
  fly     ///< right button: as turn, while letters move the camera
};

/// Tracks the mouse through a window's events.
class MouseDrags {
 public:
  /// pixels_per_unit: of the window's coordinates.
  void show(double pixels_per_unit) { pixels_per_unit_ = pixels_per_unit; }

  /// The pointer's motion in pixels, right and down; zero unless dragging.
  DVec2 follow(const PointerMoved& moved);

  /// The place of a left click without a drag, in pixels from the window's top left; nullopt if the
  /// event did not complete one.
  std::optional<DVec2> follow(const MouseButtonMoved& button, bool holds_alt);

  /// The current drag.
  Drag drag() const { return drag_; }

 private:
  double pixels_per_unit_ = 1.0;
  std::optional<DVec2> pointer_;  ///< pixels
  Drag drag_ = Drag::none;
  int button_ = 0;       ///< the held one, while dragging
  double way_px_ = 0.0;  ///< length of the drag so far
};

/// A camera's position and direction.
struct Standing {
  Vec3 position{0.0F};  ///< in the scene's coordinates
  AzimuthElevation heading;
};

/// Turns the camera about `pivot`, which keeps its place in the view and its distance. The
/// elevation stops at the zenith and the nadir.
Standing orbited(const Standing& standing, const Vec3& pivot, const Turn& turn);

/// The speed that crosses a space of this width in ten seconds, in metres per second; 1 for width
/// 0.
double walking_speed(double width_m);

/// The first hit of a line of sight.
struct Sighted {
  std::string object;    ///< its name
  std::string material;  ///< its name
  Vec3 position{0.0F};   ///< in the scene's coordinates
  double distance_m = 0.0;
  Bounds bounds;  ///< of the object
};

/// A camera's knowledge of its scene.
struct CameraSurroundings {
  Bounds bounds;      ///< of the whole scene
  DVec3 origin{0.0};  ///< Scene::origin: messages give the file's coordinates
  Standing start;     ///< the initial standing
  /// The first hit from a place (in the scene's coordinates) in a direction of unit length.
  std::function<std::optional<Sighted>(const Vec3& from, const Vec3& direction)> look;
};

class FreeCamera {
 public:
  /// head: the shown head, turned by keys and mouse. Must outlive it.
  FreeCamera(CameraSurroundings surroundings, SteeredHeadTracker& head)
      : FreeCamera(std::move(surroundings), head, &head, {}) {}
  /// head: the shown head, turned only by `turned_by` ("a recording" for instance); attempts to
  /// turn it are answered with a note. Must outlive it.
  FreeCamera(CameraSurroundings surroundings, HeadTracker& head, std::string turned_by)
      : FreeCamera(std::move(surroundings), head, nullptr, std::move(turned_by)) {}

  /// Continues in other surroundings, at the same place in the file's world.
  void move_into(CameraSurroundings surroundings);

  /// Sets the window's size and view.
  void show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit);

  /// Handles events that steer the camera. Returns whether the event is used up.
  bool follow(const WindowEvent& event);

  /// Moves to `now` at the held keys' speed. Times must not decrease.
  void walk_until(Nanoseconds now);

  /// Moves back until the last picked object, or the whole scene, is in view.
  void fit(Nanoseconds now);
  /// Returns to the initial standing.
  void go_back(Nanoseconds now);

  /// Turns the head, if possible, so that the content at direction `from` appears at `to`. Unit
  /// length, in the head's axes. Exact on the horizon.
  void bring(Nanoseconds now, const Vec3& from, const Vec3& to);

  const Vec3& position() const { return position_; }
  /// In the file's coordinates, as for --camera.
  DVec3 place() const { return DVec3(position_) + surroundings_.origin; }
  double speed_m_per_s() const { return speed_m_per_s_; }
  /// Whether it is moving, so that its view changes.
  bool is_moving() const {
    return !held_.empty() || (mouse_.drag() == Drag::orbit && steered_head_ != nullptr);
  }

  /// The note for the user since the last call; empty if none.
  std::string take_note() { return std::exchange(note_, {}); }

 private:
  FreeCamera(CameraSurroundings surroundings, HeadTracker& shown, SteeredHeadTracker* steered,
             std::string turned_by);

  bool steer(Nanoseconds time, const KeyMoved& key);
  bool steer(Nanoseconds time, const CharacterTyped& typed) const;
  bool steer(Nanoseconds time, const WheelTurned& wheel);
  bool steer(Nanoseconds time, const MouseButtonMoved& button);
  bool steer(Nanoseconds time, const PointerMoved& moved);
  bool steer(Nanoseconds time, const GamepadMoved& gamepad);
  /// Whether the head can be turned; leaves a note if not.
  bool can_turn();
  bool moves_while_held(int key) const;
  void look_at(Nanoseconds time, const DVec2& place_px);
  void orbit(Nanoseconds time, const DVec2& way_px);
  void stand(Nanoseconds time, const Standing& standing);
  Standing standing(Nanoseconds time);
  /// The motion per second by held keys, in the world.
  Vec3 velocity(const Quat& head) const;

  CameraSurroundings surroundings_;
  HeadTracker* head_;                 ///< the shown head
  SteeredHeadTracker* steered_head_;  ///< the same if it can be turned; otherwise null
  std::string turned_by_;             ///< the head's mover if it cannot
  Vec3 position_;
  double first_speed_m_per_s_;
  double speed_m_per_s_;
  ViewGeometry geometry_;
  IVec2 framebuffer_{1};
  MouseDrags mouse_;
  std::set<int> modifiers_;  ///< held Shift, Control and Alt
  std::set<int> held_;       ///< held keys that move it
  Nanoseconds since_{0};     ///< the time of its present position
  std::optional<Sighted> picked_;
  Vec3 pivot_{0.0F};  ///< centre of the mouse's orbit
  std::string note_;
};

}  // namespace foveola
