// Whether a participant sees the object of a trial, and looks at it, while the trial goes on; what
// the record says of it afterwards is in attempt_gaze_figures.
#pragma once

#include "renderer/base/clock.h"
#include "renderer/view/viewport.h"
#include "study/record/session_recorder.h"
#include "study/stage/offered_object.h"

namespace foveola::study {

/// Where an object is in a view.
struct ObjectSight {
  double from_middle_deg = 0.0;  ///< Angle between the object's middle and the view's.
  bool is_in_view = false;       ///< Whether the view shows the object's middle.
};

ObjectSight object_sight(const Viewport& view, const OfferedObject& object);

/// For how long of an attempt the gaze was where.
struct LookingTimes {
  Nanoseconds on_object{0};
  Nanoseconds elsewhere{0};
  Nanoseconds unknown{0};  ///< Without a valid gaze.

  /// A frame was shown for so long.
  void add(const FrameRow& frame, Nanoseconds shown, const OfferedObject& object);

  /// Their parts of the whole, in [0, 1]; 0 of nothing.
  double part_elsewhere() const;
  double part_unknown() const;
};

}  // namespace foveola::study
