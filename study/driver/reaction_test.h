// Times one press of a reaction test: a stimulus appears after an unpredictable wait.
#pragma once

#include <optional>

#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// One press, or a false start. The caller keeps the clock and the display.
class ReactionTest {
 public:
  /// The stimulus appears after a wait that is drawn from `random`, uniformly between the settings'
  /// limits.
  ReactionTest(const ReactionSettings& settings, Nanoseconds start, Pcg32& random);

  Nanoseconds due() const { return due_; }
  bool appears_at(Nanoseconds now) const { return now >= due_; }
  /// Records that the stimulus is visible since `time`; only the first call counts.
  void was_shown(Nanoseconds time);
  /// Records the key press; only the first call counts.
  void was_pressed(Nanoseconds time);

  /// Returns the press once it is known whether it followed the stimulus. If a false start precedes
  /// the due time, `shown` is the due time.
  std::optional<ReactionPressed> result() const;

 private:
  Nanoseconds due_;
  std::optional<Nanoseconds> shown_;
  std::optional<Nanoseconds> pressed_;
};

}  // namespace foveola::study
