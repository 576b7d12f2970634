// Tracks whether a participant sees and looks at a trial's object during the trial.
// attempt_gaze_figures is its counterpart for records.
#pragma once

#include "renderer/base/clock.h"
#include "renderer/view/viewport.h"
#include "study/record/write/session_recorder.h"
#include "study/stage/offered_object.h"

namespace foveola::study {

struct ObjectSight {
  double from_middle_deg = 0.0;  ///< Angle between the centres of the object and the view.
  bool is_in_view = false;       ///< Whether the view shows the object's centre.
};

ObjectSight object_sight(const Viewport& view, const OfferedObject& object);

/// Durations of an attempt by the gaze's place.
struct LookingTimes {
  Nanoseconds on_object{0};
  Nanoseconds elsewhere{0};
  Nanoseconds unknown{0};  ///< Without a valid gaze.

  void add(const FrameRow& frame, Nanoseconds shown, const OfferedObject& object);

  /// Return fractions of the whole, in [0, 1]; 0 if it is empty.
  double part_elsewhere() const;
  double part_unknown() const;
};

}  // namespace foveola::study
