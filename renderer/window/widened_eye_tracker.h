// The gaze in a view that is wider, or narrower, than the screen that shows it is seen.
#pragma once

#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// A tracker sees which place of a screen the eye looks at, as an angle from its middle. Where the
/// view has other angles than the eye, this turns them into the view's.
class WidenedEyeTracker final : public EyeTracker {
 public:
  /// source: must outlive it.
  explicit WidenedEyeTracker(EyeTracker& source) : source_(&source) {}

  /// Directions are so many times farther from straight ahead on a plane before the eye, from the
  /// next poll on; > 0. At 1 samples stay as they are, to the bit.
  void widen(double times) { times_ = times; }

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string status() const override { return source_->status(); }

 private:
  EyeTracker* source_;
  double times_ = 1.0;
};

}  // namespace foveola
