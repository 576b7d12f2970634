// The eye tracker of tests that say themselves what it delivers.
#pragma once

#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola::test {

/// Delivers once what the test puts into it.
class TestEyeTracker final : public EyeTracker {
 public:
  void poll(Nanoseconds /*now*/, std::vector<GazeSample>& arrived) override {
    arrived.insert(arrived.end(), next.begin(), next.end());
    next.clear();
  }
  std::string status() const override { return says; }

  std::vector<GazeSample> next;
  std::string says;  ///< its status
};

}  // namespace foveola::test
