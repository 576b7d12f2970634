// Gaze samples on their way from the thread that reads a tracker to the one that polls it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// Keeps them in the order of their arrival. Its owner sees to it that one thread uses it at a
/// time.
class SampleQueue {
 public:
  /// The most samples kept while nobody polls, nine minutes at 120 Hz; beyond, the older half goes.
  static constexpr std::size_t capacity = 1U << 16U;

  /// Takes no new memory while it is polled every two seconds, at 120 Hz.
  SampleQueue() { samples_.reserve(256); }

  void push(std::span<const GazeSample> samples) {
    samples_.insert(samples_.end(), samples.begin(), samples.end());
    if (samples_.size() > capacity) {
      samples_.erase(samples_.begin(), samples_.end() - capacity / 2);
    }
  }

  /// Appends all that it keeps to `arrived`, and keeps none of it any longer.
  void take(std::vector<GazeSample>& arrived) {
    arrived.insert(arrived.end(), samples_.begin(), samples_.end());
    samples_.clear();
  }

 private:
  std::vector<GazeSample> samples_;
};

}  // namespace foveola
