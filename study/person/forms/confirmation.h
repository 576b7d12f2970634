// The choice that a participant makes before something that is not to happen by a slip.
#pragma once

#include <optional>

#include "study/person/forms/question_entry.h"
#include "study/protocol/texts.h"
#include "study/session/session.h"

namespace foveola::study {

enum class Confirmed { timing_again, stopping };

/// A list of two: to continue, which is chosen at first, and what is to be confirmed.
class Confirmation {
 public:
  Confirmation(Confirmed what, const Texts& texts);

  Confirmed what() const { return what_; }
  /// Chooses by arrows, digits or a step. Returns whether the key meant something.
  bool follow(const FormInput& input);
  /// The event of what is chosen; empty while that is to continue.
  std::optional<Event> chosen() const;
  ScreenPage screen(const Texts& texts) const;

 private:
  Confirmed what_;
  QuestionEntry entry_;
};

}  // namespace foveola::study
