// A person's eye tracker in a session: applies the validation's correction, detects its loss.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola::study {

class PersonTracker final : public EyeTracker {
 public:
  /// The tracker is lost after this long without a sample: a blink sends invalid ones, an unplugged
  /// device none.
  static constexpr Nanoseconds longest_silence = std::chrono::seconds(1);

  /// source must outlive it.
  explicit PersonTracker(EyeTracker& source) : source_(&source) {}

  /// Sets the correction from the next sample on; empty: none.
  void correct(const std::optional<GazeCorrection>& correction) { correction_ = correction; }

  /// There is gaze until the newest valid sample is this old: longer than the longest blinks.
  static constexpr Nanoseconds longest_blink = std::chrono::milliseconds(500);

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  /// The next poll first repeats the newest valid sample, so that a new reader knows the gaze from
  /// its first poll on. Does nothing if there is none.
  void repeat_newest() { repeats_newest_ = true; }
  std::string status() const override { return source_->status(); }

  /// Returns whether a valid sample within longest_blink before `now` has been polled.
  bool has_gaze(Nanoseconds now) const {
    return newest_valid_ && now - newest_valid_->time <= longest_blink;
  }
  /// Whether samples have stopped, as of the last poll.
  bool is_lost() const { return is_lost_; }

 private:
  EyeTracker* source_;
  std::optional<GazeCorrection> correction_;
  /// Arrival time of the newest sample; before the first sample, the time of the first poll.
  std::optional<Nanoseconds> last_arrival_;
  std::optional<GazeSample> newest_valid_;  ///< the newest valid sample, corrected
  bool repeats_newest_ = false;
  bool is_lost_ = false;
};

}  // namespace foveola::study
