#include "tests/study/session/whole_procedure.h"

#include <array>

namespace foveola::study {

Procedure whole_procedure() {
  return {.agenda = {ConsentStep{}, QuestionnaireStep{"background"}, ValidationStep{.attempts = 2},
                     ReactionStep{.presses = 2}, TrialStep{.trial = 0, .chooses_object = true},
                     TrialStep{.trial = 1, .chooses_object = false}, QuestionnaireStep{"debrief"}},
          .marks = 2,
          .ratings = {{.id = "artifacts", .minimum = 1, .maximum = 5},
                      {.id = "comment", .kind = QuestionKind::text, .required = false}}};
}

std::vector<Event> all_events() {
  const Rated rated{{{"artifacts", 4.0}}};
  return {SessionStarted{},
          ConsentGiven{},
          QuestionnaireAnswered{"background", {}},
          GazeValidated{.passed = true},
          ReactionPressed{.shown = at(1), .time = at(2)},
          ReactionPressed{.shown = at(3), .time = at(4)},
          ObjectChosen{"vase"},
          TrialStarted{},
          FirstFramePresented{at(10)},
          Marked{at(20)},
          Marked{at(30)},
          rated,
          TrialStarted{},
          FirstFramePresented{at(110)},
          Marked{at(120)},
          TimedOut{at(130)},
          rated,
          QuestionnaireAnswered{"debrief", {}}};
}

std::vector<Event> events_of_first_trial() {
  const std::vector<Event> all = all_events();
  return {all.begin(), all.begin() + 11};
}

std::vector<std::string> names_of(const std::vector<Effect>& effects) {
  constexpr std::array names = {"AskForConsent",  "AskQuestionnaire", "ValidateGaze",
                                "AskForPress",    "AskForObject",     "AskWhetherReady",
                                "StartRendering", "AcknowledgeMark",  "AskForRating",
                                "StopRendering",  "ShowPause",        "EndSession"};
  static_assert(names.size() == std::variant_size_v<Effect>);
  std::vector<std::string> result;
  for (const Effect& effect : effects) {
    result.emplace_back(names.at(effect.index()));
  }
  return result;
}

}  // namespace foveola::study
