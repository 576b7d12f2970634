// Whether a participant sees the object of a trial, and looks at it.
#pragma once

#include "renderer/base/clock.h"
#include "renderer/view/viewport.h"
#include "study/participant/participant.h"

namespace foveola::study {

/// Where an object is in a view.
struct ObjectSight {
  double from_middle_deg = 0.0;  ///< Angle between the object's middle and the view's.
  bool is_in_view = false;       ///< Whether the view shows the object's middle.
};

ObjectSight object_sight(const Viewport& view, const OfferedObject& object);

/// The gaze is on an object if it is no further outside its radius: eye trackers err by about a
/// degree (1.5 degrees is the largest error that a validation accepts by default), and people look
/// at an object's edge as well.
inline constexpr double gaze_margin_deg = 2.0;

/// gaze: unit length, world.
bool is_gaze_on(const OfferedObject& object, const Vec3& gaze);

/// For how long of an attempt the gaze was where.
struct GazeTimes {
  Nanoseconds on_object{0};
  Nanoseconds elsewhere{0};
  Nanoseconds unknown{0};  ///< Without a valid gaze.

  /// Their parts of the whole, in [0, 1]; 0 of nothing.
  double part_elsewhere() const;
  double part_unknown() const;
};

}  // namespace foveola::study
