#include "study/person/key_words.h"

#include <fmt/format.h>

namespace foveola::study {
namespace {

std::string words_in_phase(const PromptState& prompt, const SessionContext& context) {
  switch (context.seen.phase) {
    case Phase::consent:
      return "Y agrees, N does not";
    case Phase::questionnaire:
      return "answers, and Enter hands them in";
    case Phase::validation:
      return prompt.validation ? "none: the participant looks at targets"
                               : "Space begins the targets";
    case Phase::reaction:
      return "Space, as soon as the page lights up";
    case Phase::choosing_object:
      return fmt::format("Tab goes on to another object, Enter chooses {}", prompt.object.name);
    case Phase::ready:
      return "Space starts the trial";
    case Phase::armed:
      return prompt.awaits_gaze ? "none: the trial waits for a gaze" : "none: the trial begins";
    case Phase::marking:
      return fmt::format("Space marks {}", context.protocol.marks[context.seen.mark].id);
    case Phase::rating:
      return prompt.form ? "ratings, and Enter hands them in" : "Enter, to rate the trial";
    case Phase::paused:
      return "Space or Enter goes on";
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      return "Enter closes the window";
    case Phase::created:
    case Phase::interrupted:
      break;
  }
  return "none";
}

}  // namespace

std::string words_for_next_key(const PromptState& prompt, const SessionContext& context) {
  if (prompt.confirmation) {
    return prompt.confirmation == Confirmation::timing_again
               ? "R times the trial again, Backspace goes back to it"
               : "Y stops taking part, N goes on";
  }
  return prompt.notices.empty() ? words_in_phase(prompt, context)
                                : "Space or Enter, once the notice is read";
}

}  // namespace foveola::study
