// The presses of a reaction test as a display and a key bring them, one after the other.
#pragma once

#include <optional>

#include "study/driver/reaction_test.h"

namespace foveola::study {

enum class ReactionLook {
  waiting,
  waiting_again,  ///< after a press that came too early
  appeared,
};

/// Whoever drives it keeps the clock, frame by frame.
class ReactionPresses {
 public:
  /// waits: draws how long nothing appears.
  explicit ReactionPresses(const Pcg32& waits) : waits_(waits) {}

  /// The next press is asked for; its wait begins with the next frame that is shown.
  void ask() { test_.reset(); }
  /// Before a frame is drawn.
  void begin_frame(Nanoseconds now) { appears_ = test_ && test_->appears_at(now); }
  /// The frame was shown. Returns a press once it is known; then the next one is waited for.
  std::optional<ReactionPressed> end_frame(const ReactionSettings& settings, Nanoseconds shown);
  /// The key; before the first wait it means nothing.
  void press(Nanoseconds time);
  /// A press is on the disk, and may therefore be known.
  void was_kept(const ReactionPressed& pressed) { was_early_ = pressed.time < pressed.shown; }

  /// Whether the press that was kept last came too early.
  bool was_early() const { return was_early_; }
  /// What the frame shows.
  ReactionLook look() const;

 private:
  Pcg32 waits_;
  std::optional<ReactionTest> test_;
  bool appears_ = false;  ///< in this frame
  bool was_early_ = false;
};

}  // namespace foveola::study
