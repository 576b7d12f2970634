// A camera that its user moves: walking and flying by keys, around what was picked by the mouse, to
// what is clicked on; what the mouse's buttons and keys mean for it.
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

/// What moving the mouse does, by the button that is held.
enum class Drag {
  none,
  turn,   ///< the left one
  orbit,  ///< the middle one, or the left one with Alt
  fly     ///< the right one: as turn, while letters move the camera
};

/// Follows the mouse through a window's events.
class MouseDrags {
 public:
  /// pixels_per_unit: of the window's coordinates.
  void show(double pixels_per_unit) { pixels_per_unit_ = pixels_per_unit; }

  /// How far the pointer went in pixels, right and down; zero unless it is being dragged.
  DVec2 follow(const PointerMoved& moved);

  /// Where the left button was pressed and let go again without a drag, in pixels from the window's
  /// top left; empty if it was not.
  std::optional<DVec2> follow(const MouseButtonMoved& button, bool holds_alt);

  /// What goes on.
  Drag drag() const { return drag_; }

 private:
  double pixels_per_unit_ = 1.0;
  std::optional<DVec2> pointer_;  ///< pixels
  Drag drag_ = Drag::none;
  int button_ = 0;       ///< the one that is held, while something is dragged
  double way_px_ = 0.0;  ///< how far the pointer went since it is held
};

/// Where a camera stands, and where it looks.
struct Standing {
  Vec3 position{0.0F};  ///< in the scene's coordinates
  AzimuthElevation heading;
};

/// Turns the camera, and moves it so that `pivot` stays in its place in the view and at its
/// distance. The elevation stops at the zenith and at the nadir.
Standing orbited(const Standing& standing, const Vec3& pivot, const Turn& turn);

/// The speed at which a space so many metres wide is walked through in ten seconds, in metres a
/// second; 1 if it has no size.
double walking_speed(double width_m);

/// What a line of sight meets first.
struct Sighted {
  std::string object;    ///< its name
  std::string material;  ///< its name
  Vec3 position{0.0F};   ///< in the scene's coordinates
  double distance_m = 0.0;
  Bounds bounds;  ///< of the object
};

/// What a camera needs to know of the scene in which it moves.
struct CameraSurroundings {
  Bounds bounds;      ///< of all there is
  DVec3 origin{0.0};  ///< Scene::origin: what is said in words is in the file's coordinates
  Standing start;     ///< where it stands to begin with
  /// What is seen from a place (in the scene's coordinates) in a direction of unit length.
  std::function<std::optional<Sighted>(const Vec3& from, const Vec3& direction)> look;
};

class FreeCamera {
 public:
  /// head: the one that is shown; keys and mouse turn it. Must outlive it.
  FreeCamera(CameraSurroundings surroundings, SteeredHeadTracker& head)
      : FreeCamera(std::move(surroundings), head, &head, {}) {}
  /// head: the one that is shown. Only turned_by, "a recording" for instance, turns it, and who
  /// tries otherwise is told so. Must outlive it.
  FreeCamera(CameraSurroundings surroundings, HeadTracker& head, std::string turned_by)
      : FreeCamera(std::move(surroundings), head, nullptr, std::move(turned_by)) {}

  /// Goes on in other surroundings, at the same place in the file's world.
  void move_into(CameraSurroundings surroundings);

  /// How large the window is, and what it shows from now on.
  void show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit);

  /// Follows what steers the camera. Returns whether the event means nothing else.
  bool follow(const WindowEvent& event);

  /// Goes on to `now` at the speed that held keys give it. Times may not go backwards.
  void walk_until(Nanoseconds now);

  /// Shows what was picked last, or all there is, from a distance.
  void fit(Nanoseconds now);
  /// Back to where it stood to begin with.
  void go_back(Nanoseconds now);

  /// Turns the head, if it can be turned, so that what was seen in one direction is seen in
  /// another. Unit length, in the head's axes. Exact on the horizon.
  void bring(Nanoseconds now, const Vec3& from, const Vec3& to);

  const Vec3& position() const { return position_; }
  /// As --camera takes it: in the file's coordinates.
  DVec3 place() const { return DVec3(position_) + surroundings_.origin; }
  double speed_m_per_s() const { return speed_m_per_s_; }
  /// Whether it is being moved, so that what is seen does not stay.
  bool is_moving() const {
    return !held_.empty() || (mouse_.drag() == Drag::orbit && steered_head_ != nullptr);
  }

  /// What it has to say since the last call, for the user; empty if nothing.
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
  /// Whether the head can be turned; tells the user if not.
  bool can_turn();
  bool moves_while_held(int key) const;
  void look_at(Nanoseconds time, const DVec2& place_px);
  void orbit(Nanoseconds time, const DVec2& way_px);
  void stand(Nanoseconds time, const Standing& standing);
  Standing standing(Nanoseconds time);
  /// The way that held keys go in a second, in the world.
  Vec3 velocity(const Quat& head) const;

  CameraSurroundings surroundings_;
  HeadTracker* head_;                 ///< the one that is shown
  SteeredHeadTracker* steered_head_;  ///< the same if it can be turned; else null
  std::string turned_by_;             ///< what turns it then
  Vec3 position_;
  double first_speed_m_per_s_;
  double speed_m_per_s_;
  ViewGeometry geometry_;
  IVec2 framebuffer_{1};
  MouseDrags mouse_;
  std::set<int> modifiers_;  ///< Shift, Control and Alt, as they are held
  std::set<int> held_;       ///< the keys that move it
  Nanoseconds since_{0};     ///< up to when it has moved
  std::optional<Sighted> picked_;
  Vec3 pivot_{0.0F};  ///< what the mouse's orbit goes around
  std::string note_;
};

}  // namespace foveola
