// The minimum over a sliding window of time.
#pragma once

#include <deque>

#include "renderer/base/clock.h"

namespace foveola {

/// The minimum of the values whose times are at most `window` before the newest. Each is added and
/// dropped once.
template <typename Value>
class SlidingMinimum {
 public:
  explicit SlidingMinimum(Nanoseconds window) : window_(window) {}

  /// Times may not go backwards.
  void add(Nanoseconds time, const Value& value) {
    while (!candidates_.empty() && candidates_.back().value >= value) {
      candidates_.pop_back();
    }
    candidates_.push_back({time, value});
    while (time - candidates_.front().time > window_) {
      candidates_.pop_front();
    }
  }

  /// The minimum; there must be at least one value.
  const Value& least() const { return candidates_.front().value; }

  void clear() { candidates_.clear(); }

 private:
  struct Candidate {
    Nanoseconds time{0};
    Value value;
  };

  Nanoseconds window_;
  /// Those that are or may become the least: times and values ascend.
  std::deque<Candidate> candidates_;
};

}  // namespace foveola
