// A person's eye tracker in a session: corrected by what its validation says, and watched for being
// lost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_correction.h"

namespace foveola::study {

class PersonTracker final : public EyeTracker {
 public:
  /// Without a sample for longer, it is lost: a blink sends invalid ones, an unplugged device none.
  static constexpr Nanoseconds longest_silence = std::chrono::seconds(1);

  /// source must outlive it.
  explicit PersonTracker(EyeTracker& source) : source_(&source) {}

  /// From the next sample on; empty: as it comes.
  void correct(const std::optional<GazeCorrection>& correction) { correction_ = correction; }

  void poll(Nanoseconds now, std::vector<GazeSample>& arrived) override;
  std::string trouble() const override { return source_->trouble(); }

  /// Whether samples no longer come, as of the last poll.
  bool is_lost() const { return is_lost_; }

 private:
  EyeTracker* source_;
  std::optional<GazeCorrection> correction_;
  std::optional<Nanoseconds> last_arrival_;  ///< or the first poll
  bool is_lost_ = false;
};

}  // namespace foveola::study
