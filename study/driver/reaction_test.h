// How fast a finger is: something appears after a while that nobody can guess, and a key is pressed
// at it.
#pragma once

#include <optional>

#include "renderer/base/clock.h"
#include "renderer/base/random.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// One press, or a false start. Whoever drives it keeps the clock and the display.
class ReactionTest {
 public:
  /// It appears after a wait that is drawn from `random`, uniformly between the settings' limits.
  ReactionTest(const ReactionSettings& settings, Nanoseconds start, Pcg32& random);

  /// When the display should show it.
  Nanoseconds due() const { return due_; }
  /// Whether the display should show it by now.
  bool appears_at(Nanoseconds now) const { return now >= due_; }
  /// The display has shown it since `time`; the first call counts.
  void was_shown(Nanoseconds time);
  /// The key was pressed; the first call counts.
  void was_pressed(Nanoseconds time);

  /// The press, once it is known whether it was one at what appeared. Of a false start before the
  /// thing was even due, `shown` is when it would have been.
  std::optional<ReactionPressed> result() const;

 private:
  Nanoseconds due_;
  std::optional<Nanoseconds> shown_;
  std::optional<Nanoseconds> pressed_;
};

}  // namespace foveola::study
