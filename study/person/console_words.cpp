#include "study/person/console_words.h"

#include <fmt/format.h>

namespace foveola::study {
namespace {

// What there is to say about some events beside their names.
/// The first line: an amended protocol's note holds its whole text.
std::string detail_of(const NoteWritten& note) { return note.text.substr(0, note.text.find('\n')); }
std::string detail_of(const Excluded& excluded) { return excluded.reason; }
std::string detail_of(const ObjectChosen& chosen) { return chosen.object; }
std::string detail_of(const QuestionnaireAnswered& answered) { return answered.questionnaire; }
std::string detail_of(const ReactionPressed& press) {
  return press.time < press.shown
             ? "too early"
             : fmt::format("after {:.0f} ms", 1e3 * seconds(press.time - press.shown));
}
std::string detail_of(const GazeValidated& validated) {
  const GazeQuality& quality = validated.runs.back().quality;
  return quality.figures
             ? fmt::format("{}, accuracy {:.2f} degrees, precision {:.2f}, {:.0f} % lost",
                           validated.passed ? "good enough" : "not good enough",
                           quality.figures->accuracy_deg, quality.figures->precision_rms_deg,
                           100.0 * quality.data_loss)
             : "the tracker saw no eye look at any target";
}
template <typename Other>
std::string detail_of(const Other& /*event*/) {
  return {};
}

std::string words_for_trial(std::size_t index, const Plan& plan) {
  const PlannedTrial& trial = plan[index];
  return fmt::format("trial {} of {}{}: {} with {}", index + 1, plan.size(),
                     trial.kind == TrialKind::test ? "" : fmt::format(" ({})", name_of(trial.kind)),
                     trial.scene, trial.method);
}

std::string words_for_step(const AgendaStep& step, const Plan& plan) {
  struct Words {
    const Plan& plan;
    std::string operator()(const ConsentStep& /*step*/) const { return "consent"; }
    std::string operator()(const QuestionnaireStep& step) const {
      return "questionnaire " + step.questionnaire;
    }
    std::string operator()(const ValidationStep& /*step*/) const { return "validation"; }
    std::string operator()(const ReactionStep& step) const {
      return fmt::format("{} reaction presses", step.presses);
    }
    std::string operator()(const TrialStep& step) const {
      return words_for_trial(step.trial, plan);
    }
  };
  return std::visit(Words{plan}, step);
}

}  // namespace

std::string words_for(const Event& event) {
  const std::string detail = std::visit([](const auto& one) { return detail_of(one); }, event);
  return detail.empty() ? std::string(name_of(event)) : name_of(event) + (": " + detail);
}

std::string words_for(const SessionState& state, const Procedure& procedure, const Plan& plan) {
  std::string words = name_of(state.phase);
  if (state.is_over() || state.step >= procedure.agenda.size()) {
    return words;
  }
  words += ", " + words_for_step(procedure.agenda[state.step], plan);
  if (trial_of(procedure, state)) {
    words += fmt::format(", timing {}, attempt {}", state.timing, state.attempt);
  }
  return words;
}

std::string words_for_next(const SessionState& state, const Procedure& procedure,
                           const Plan& plan) {
  const std::size_t next = state.step + 1;
  if (state.is_over() || next >= procedure.agenda.size()) {
    return "the session's end";
  }
  return words_for_step(procedure.agenda[next], plan);
}

}  // namespace foveola::study
