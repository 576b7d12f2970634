#include "study/person/prompts/reaction_presses.h"

namespace foveola::study {

std::optional<ReactionPressed> ReactionPresses::end_frame(const ReactionSettings& settings,
                                                          Nanoseconds shown) {
  if (!test_) {
    test_.emplace(settings, shown, waits_);
    return std::nullopt;
  }
  if (appears_) {
    test_->was_shown(shown);
  }
  const std::optional<ReactionPressed> pressed = test_->result();
  if (pressed) {
    test_.reset();
  }
  return pressed;
}

void ReactionPresses::press(Nanoseconds time) {
  if (test_) {
    test_->was_pressed(time);
  }
}

ReactionLook ReactionPresses::look() const {
  if (appears_) {
    return ReactionLook::appeared;
  }
  return was_early_ ? ReactionLook::waiting_again : ReactionLook::waiting;
}

}  // namespace foveola::study
