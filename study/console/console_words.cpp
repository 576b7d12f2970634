#include "study/console/console_words.h"

#include <fmt/format.h>

#include "renderer/base/text/utf8.h"

namespace foveola::study {
namespace {

struct Happened {
  const SessionState& after;
  const Protocol& protocol;

  const std::string& last_mark() const { return protocol.marks[after.mark - 1].id; }

  std::string operator()(const SessionStarted& /*event*/) const { return "The session begins."; }
  std::string operator()(const ConsentGiven& /*event*/) const { return "Consent was given."; }
  std::string operator()(const QuestionnaireAnswered& answered) const {
    return fmt::format("The questionnaire {} was filled in.", answered.questionnaire);
  }
  std::string operator()(const GazeValidated& validated) const {
    const GazeQuality& quality = validated.runs.back().quality;
    return quality.figures
               ? fmt::format(
                     "The gaze was validated, {}: accuracy {:.2f} degrees, precision {:.2f}, "
                     "{:.0f} % lost.",
                     validated.passed ? "good enough" : "not good enough",
                     quality.figures->accuracy_deg, quality.figures->precision_rms_deg,
                     100.0 * quality.data_loss)
               : "The gaze was not validated: there was no valid gaze at any target.";
  }
  std::string operator()(const ReactionPressed& press) const {
    return press.time < press.shown ? "A reaction came too early."
                                    : fmt::format("A reaction came after {:.0f} ms.",
                                                  1e3 * seconds(press.time - press.shown));
  }
  std::string operator()(const ObjectChosen& chosen) const {
    return fmt::format("The object {} was chosen.", chosen.object);
  }
  std::string operator()(const TrialStarted& /*event*/) const { return "The trial was started."; }
  std::string operator()(const FirstFramePresented& /*event*/) const {
    return "Its first frame is shown.";
  }
  std::string operator()(const Marked& marked) const {
    return fmt::format("{} was marked after {:.3f} s.", last_mark(),
                       seconds(marked.time - after.first_frame));
  }
  std::string operator()(const TimedOut& timed_out) const {
    return fmt::format("{} was not marked in {:g} s.", last_mark(),
                       seconds(timed_out.time - after.first_frame));
  }
  std::string operator()(const Rated& /*event*/) const { return "The trial was rated."; }
  std::string operator()(const RetimeRequested& /*event*/) const {
    return "The trial will be retimed.";
  }
  std::string operator()(const PauseRequested& /*event*/) const { return "The session pauses."; }
  std::string operator()(const Interrupted& /*event*/) const {
    return "The session is interrupted.";
  }
  std::string operator()(const Resumed& /*event*/) const { return "The session continues."; }
  /// Prints the note's beginning: an amended protocol's note has its whole text, a resumed
  /// session's all facts of its devices.
  std::string operator()(const NoteWritten& note) const {
    constexpr std::size_t max_characters = 160;
    return "Note: " + beginning_of(note.text, max_characters);
  }
  std::string operator()(const Withdrawn& /*event*/) const {
    return "The participant stopped taking part.";
  }
  std::string operator()(const Excluded& excluded) const {
    return fmt::format("The session was excluded: {}.", excluded.reason);
  }
  std::string operator()(const EndUndone& /*event*/) const {
    return "The session's end is undone; it is paused.";
  }
  std::string operator()(const ConsentAsked& /*event*/) const {
    return "The consent's text has changed: it is asked for anew.";
  }
};

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

/// Returns an empty text if the step itself describes the phase.
std::string words_for(Phase phase) {
  switch (phase) {
    case Phase::consent:
    case Phase::questionnaire:
    case Phase::validation:
    case Phase::reaction:
      return "";
    case Phase::choosing_object:
      return "choosing an object";
    case Phase::ready:
      return "ready to start";
    case Phase::armed:
      return "about to begin";
    default:
      return name_of(phase);
  }
}

}  // namespace

std::string words_for(const Event& event, const SessionState& after, const Protocol& protocol) {
  return std::visit(Happened{after, protocol}, event);
}

std::string words_for(const SessionState& state, const Procedure& procedure, const Plan& plan) {
  const std::string phase = words_for(state.phase);
  if (state.is_over() || state.step >= procedure.agenda.size()) {
    return phase;
  }
  const std::string step = state.phase == Phase::consent
                               ? "consent"
                               : words_for_step(procedure.agenda[state.step], plan);
  std::string words = phase.empty() ? step : phase + ", " + step;
  if (trial_of(procedure, state)) {
    words += fmt::format(", timing {}, attempt {}", state.timing, state.attempt);
  }
  return words;
}

Plan without_methods(Plan plan) {
  for (PlannedTrial& trial : plan) {
    trial.method = "a hidden method";
    trial.kind = trial.kind == TrialKind::catch_trial ? TrialKind::test : trial.kind;
  }
  return plan;
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
