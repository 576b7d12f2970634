// A person's eye tracker in a session: corrected by what its validation says, and watched for being
// lost.
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
  /// Without a sample for longer, it is lost: a blink sends invalid ones, an unplugged device none.
  static constexpr Nanoseconds longest_silence = std::chrono::seconds(1);

  /// source must outlive it.
  explicit PersonTracker(EyeTracker& source) : source_(&source) {}

  /// Corrects the gaze from the next sample on; empty: the gaze stays as it comes.
  void correct(const std::optional<GazeCorrection>& correction) { correction_ = correction; }

  /// Until a valid sample is so old, the gaze is there: the longest blinks take less.
  static constexpr Nanoseconds longest_blink = std::chrono::milliseconds(500);

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  /// The next poll delivers the newest valid sample of those before it once more, first: for who
  /// begins to ask and must know where the eye is from the beginning. Without one, nothing.
  void repeat_newest() { repeats_newest_ = true; }
  std::string status() const override { return source_->status(); }

  /// Whether the eye was seen within longest_blink before `now`, as far as polls say.
  bool has_gaze(Nanoseconds now) const {
    return newest_valid_ && now - newest_valid_->time <= longest_blink;
  }
  /// Whether samples no longer come, as of the last poll.
  bool is_lost() const { return is_lost_; }

 private:
  EyeTracker* source_;
  std::optional<GazeCorrection> correction_;
  /// When the newest sample arrived; before there is one, the time of the first poll.
  std::optional<Nanoseconds> last_arrival_;
  std::optional<GazeSample> newest_valid_;  ///< the newest valid sample, corrected
  bool repeats_newest_ = false;
  bool is_lost_ = false;
};

}  // namespace foveola::study
