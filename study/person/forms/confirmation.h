// Asks a participant to confirm a choice that must not happen by a slip.
#pragma once

#include <optional>

#include "study/person/forms/question_entry.h"
#include "study/protocol/texts.h"
#include "study/session/session.h"

namespace foveola::study {

enum class Confirmed { timing_again, stopping };

/// A list of two: to continue, which is selected at first, and the choice to be confirmed.
class Confirmation {
 public:
  Confirmation(Confirmed what, const Texts& texts);

  Confirmed what() const { return what_; }
  /// Selects by arrows, digits or a step. Returns whether the key had a meaning.
  bool follow(const FormInput& input);
  /// Returns the event of the selected choice; empty if it is to continue.
  std::optional<Event> chosen() const;
  ScreenPage screen(const Texts& texts) const;

 private:
  Confirmed what_;
  QuestionEntry entry_;
};

}  // namespace foveola::study
