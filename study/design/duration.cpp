#include "study/design/duration.h"

#include <algorithm>
#include <array>

namespace foveola::study {
namespace {

constexpr AssumedDuration consent{"reading the consent and agreeing", {20.0, 300.0}};
constexpr AssumedDuration quick_answer{"an answer on a scale, in a number, by an option",
                                       {3.0, 20.0}};
constexpr AssumedDuration written_answer{"an answer in words", {5.0, 120.0}};
/// The time of a target in CalibrationTiming: settling and collecting, or giving up.
constexpr AssumedDuration target{"a target of a validation", {1.7, 4.0}};
constexpr AssumedDuration press{"a press at the stimulus", {0.2, 1.0}};
constexpr AssumedDuration choice{"choosing an object", {5.0, 60.0}};
constexpr AssumedDuration readiness{"getting ready for a trial", {2.0, 20.0}};
constexpr AssumedDuration soonest_mark{"a mark; at most until the time-out", {1.0, 0.0}};

constexpr std::array assumptions{consent, quick_answer, written_answer, target,
                                 press,   choice,       readiness,      soonest_mark};

Duration operator+(const Duration& a, const Duration& b) {
  return {a.least_s + b.least_s, a.most_s + b.most_s};
}

Duration operator*(double count, const Duration& each) {
  return {count * each.least_s, count * each.most_s};
}

Duration answering(const std::vector<Question>& questions) {
  Duration sum;
  for (const Question& question : questions) {
    const bool in_words = question.kind == QuestionKind::text;
    const Duration answer = in_words ? written_answer.duration : quick_answer.duration;
    sum = sum + Duration{question.required ? answer.least_s : 0.0, answer.most_s};
  }
  return sum;
}

Duration marking(const Protocol& protocol, const TrialSettings& settings) {
  const double marks = static_cast<double>(protocol.marks.size());
  const double timeout_s = settings.timing.mark_timeout_s;
  return {std::min(marks * soonest_mark.duration.least_s, timeout_s), timeout_s};
}

/// Returns the duration of a trial without choosing the object.
Duration trial_duration(const Protocol& protocol, const std::string& scene,
                        const std::string& method) {
  const TrialSettings settings = settings_of(protocol, scene, method);
  const double looking_s = settings.timing.rating_s;
  return readiness.duration + marking(protocol, settings) + Duration{looking_s, looking_s} +
         answering(protocol.ratings);
}

SessionPart practice_part(const Protocol& protocol) {
  SessionPart part{.name = "practice", .count = static_cast<int>(protocol.practice.size())};
  for (const PracticeEntry& entry : protocol.practice) {
    part.duration =
        part.duration + choice.duration + trial_duration(protocol, entry.scene, entry.method);
  }
  return part;
}

SessionPart test_part(const Protocol& protocol) {
  SessionPart part{.name = "trials", .count = 0};
  const bool once_a_scene = protocol.object_choice == ObjectChoice::per_scene;
  const double choices = once_a_scene ? 1.0 : static_cast<double>(protocol.methods.size());
  for (const SceneEntry& scene : protocol.scenes) {
    part.duration = part.duration + choices * choice.duration;
    for (const std::string& method : protocol.methods) {
      ++part.count;
      part.duration = part.duration + trial_duration(protocol, scene.name, method);
    }
  }
  return part;
}

SessionPart catch_part(const Protocol& protocol) {
  const CatchTrials& trials = protocol.catch_trials;
  const Duration nothing{trials.timeout_s, trials.timeout_s};
  return {.name = "catch trials",
          .count = trials.count,
          .duration = trials.count * (readiness.duration + nothing)};
}

SessionPart validation_part(const ValidationSettings& settings) {
  const int looks = settings.correct ? 2 : 1;
  const Duration once = settings.points * looks * target.duration;
  return {.name = "validation",
          .count = settings.points * looks,
          .duration = {once.least_s, settings.attempts * once.most_s}};
}

SessionPart reaction_part(const ReactionSettings& settings) {
  const Duration wait{settings.shortest_wait_s, settings.longest_wait_s};
  return {.name = "reaction",
          .count = settings.presses,
          .duration = settings.presses * (wait + press.duration)};
}

void add_if_any(std::vector<SessionPart>& parts, const SessionPart& part) {
  if (part.count > 0) {
    parts.push_back(part);
  }
}

void add_phase(std::vector<SessionPart>& parts, const Protocol& protocol, const PhaseEntry& phase) {
  switch (phase.kind) {
    case PhaseEntry::Kind::consent:
      parts.push_back({.name = "consent", .duration = consent.duration});
      return;
    case PhaseEntry::Kind::questionnaire: {
      const auto& questions = questionnaire_of(protocol, phase.questionnaire).questions;
      parts.push_back({.name = phase.questionnaire,
                       .count = static_cast<int>(questions.size()),
                       .duration = answering(questions)});
      return;
    }
    case PhaseEntry::Kind::validation:
      parts.push_back(validation_part(*protocol.tracker.validation));
      return;
    case PhaseEntry::Kind::reaction:
      parts.push_back(reaction_part(*protocol.reaction));
      return;
    case PhaseEntry::Kind::trials:
      add_if_any(parts, practice_part(protocol));
      parts.push_back(test_part(protocol));
      add_if_any(parts, catch_part(protocol));
      return;
  }
}

}  // namespace

std::span<const AssumedDuration> assumed_durations() { return assumptions; }

std::vector<SessionPart> session_parts(const Protocol& protocol) {
  std::vector<SessionPart> parts;
  for (const PhaseEntry& phase : protocol.phases) {
    add_phase(parts, protocol, phase);
  }
  return parts;
}

Duration total_of(const std::vector<SessionPart>& parts) {
  Duration total;
  for (const SessionPart& part : parts) {
    total = total + part.duration;
  }
  return total;
}

}  // namespace foveola::study
