// When an eye was where a runtime of OpenXR says it is, which not all of them know.
#pragma once

#include <optional>

#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// What the runtime told when it was asked.
struct ToldGaze {
  Nanoseconds asked{0};
  std::optional<Nanoseconds> sampled;  ///< empty: it does not know
  Vec3 direction{0.0F, 0.0F, -1.0F};   ///< unit length, in the head's axes
  bool is_valid = false;
};

/// Turns what a runtime tells, asked again and again, into samples: the same one is told until
/// there is another.
class GazeTimes {
 public:
  /// Empty if this is the sample before. A time that is unknown, to come, not later than that of
  /// the sample before or more than a second ago is no time: the sample then has the one at which
  /// it was asked for.
  std::optional<GazeSample> sample_of(const ToldGaze& told);

 private:
  std::optional<ToldGaze> before_;
};

}  // namespace foveola
