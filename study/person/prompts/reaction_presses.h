// Runs the presses of a reaction test, one after the other, from frames and key presses.
#pragma once

#include <optional>

#include "study/driver/reaction_test.h"

namespace foveola::study {

enum class ReactionLook {
  waiting,
  waiting_again,  ///< after a premature press
  appeared,
};

/// The caller keeps the clock, frame by frame.
class ReactionPresses {
 public:
  /// waits: draws the durations before the stimulus appears.
  explicit ReactionPresses(const Pcg32& waits) : waits_(waits) {}

  /// Asks for the next press; its wait begins with the next frame that is shown.
  void ask() { test_.reset(); }
  /// Call before a frame is drawn.
  void begin_frame(Nanoseconds now) { appears_ = test_ && test_->appears_at(now); }
  /// Call after the frame was shown. Returns a press once it is known, and then waits for the next.
  std::optional<ReactionPressed> end_frame(const ReactionSettings& settings, Nanoseconds shown);
  /// The key; ignored before the first wait.
  void press(Nanoseconds time);
  /// Records that a press is durable, and may be reported to the participant.
  void was_kept(const ReactionPressed& pressed) { was_early_ = pressed.time < pressed.shown; }

  /// Whether the last durable press was premature.
  bool was_early() const { return was_early_; }
  /// The stimulus of the frame.
  ReactionLook look() const;

 private:
  Pcg32 waits_;
  std::optional<ReactionTest> test_;
  bool appears_ = false;  ///< whether the stimulus is in this frame
  bool was_early_ = false;
};

}  // namespace foveola::study
