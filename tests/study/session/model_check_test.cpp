// Every event in every state that a small session can be in, by enumeration.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/study/session/whole_procedure.h"

namespace foveola::study {
namespace {

/// Attempts are counted without end: this many are looked at.
constexpr int max_attempts = 3;
/// More than there can be: a machine that forgets to count has no end otherwise.
constexpr std::size_t max_states = 20'000;

/// Each kind of event, with times before, at and after what they could follow.
std::vector<Event> every_event() {
  std::vector<Event> events = {SessionStarted{},
                               ConsentGiven{},
                               QuestionnaireAnswered{"background", {}},
                               QuestionnaireAnswered{"debrief", {}},
                               QuestionnaireAnswered{"another", {}},
                               GazeValidated{.passed = false},
                               GazeValidated{.passed = true},
                               ReactionPressed{.shown = at(10), .time = at(9)},
                               ReactionPressed{.shown = at(10), .time = at(10)},
                               ObjectChosen{""},
                               ObjectChosen{"vase"},
                               TrialStarted{},
                               FirstFramePresented{at(10)},
                               Rated{},
                               Rated{{{"artifacts", 0.0}}},
                               Rated{{{"artifacts", 5.0}}},
                               RetimeRequested{},
                               PauseRequested{},
                               Interrupted{},
                               Resumed{},
                               NoteWritten{"a note"},
                               Withdrawn{},
                               Excluded{"a reason"},
                               EndUndone{},
                               ConsentAsked{}};
  for (const int time : {9, 10, 11}) {
    events.emplace_back(Marked{at(time)});
    events.emplace_back(TimedOut{at(time)});
  }
  return events;
}

/// What somebody who watches a session from outside has seen so far.
struct Watched {
  SessionState state;
  bool renders = false;
  int marks = 0;                ///< since rendering began
  std::set<std::size_t> rated;  ///< trials
  std::set<std::string> forms;  ///< answered
  bool consented = false;
  bool passed = false;  ///< the validation
  int presses = 0;      ///< that were no false starts

  auto key() const {
    return std::tuple(state.phase, state.step, state.validations_left, state.presses_left,
                      state.attempt, state.timing, state.mark, state.object, state.first_frame,
                      state.last_mark, state.resumes_at, state.after_consent, renders, marks, rated,
                      forms, consented, passed, presses);
  }
};
bool operator<(const Watched& a, const Watched& b) { return a.key() < b.key(); }

std::string describe(const Watched& watched, const Event& event) {
  return std::string(name_of(event)) + " in " + name_of(watched.state.phase) + " of step " +
         std::to_string(watched.state.step);
}

/// What every participant is asked in a phase, and nothing else.
std::string question_in(Phase phase) {
  static const std::map<Phase, std::string> questions = {{Phase::consent, "AskForConsent"},
                                                         {Phase::questionnaire, "AskQuestionnaire"},
                                                         {Phase::validation, "ValidateGaze"},
                                                         {Phase::reaction, "AskForPress"},
                                                         {Phase::choosing_object, "AskForObject"},
                                                         {Phase::ready, "AskWhetherReady"},
                                                         {Phase::armed, "StartRendering"},
                                                         {Phase::rating, "AskForRating"},
                                                         {Phase::paused, "ShowPause"},
                                                         {Phase::interrupted, "EndSession"},
                                                         {Phase::completed, "EndSession"},
                                                         {Phase::withdrawn, "EndSession"},
                                                         {Phase::excluded, "EndSession"},
                                                         {Phase::refused, "EndSession"}};
  const auto found = questions.find(phase);
  return found == questions.end() ? "" : found->second;
}

/// Takes note of an event and its effects, and checks what must hold of any.
Watched watch(Watched watched, const Event& event, const Transition& transition) {
  const std::string what = describe(watched, event);
  const bool is_resumed = std::holds_alternative<Resumed>(event);
  if (std::holds_alternative<ConsentGiven>(event)) {
    watched.consented = true;
  } else if (const auto* form = std::get_if<QuestionnaireAnswered>(&event)) {
    EXPECT_TRUE(watched.forms.insert(form->questionnaire).second) << what << ": twice";
  } else if (const auto* validated = std::get_if<GazeValidated>(&event)) {
    watched.passed = watched.passed || validated->passed;
  } else if (const auto* press = std::get_if<ReactionPressed>(&event)) {
    watched.presses += press->time >= press->shown ? 1 : 0;
  } else if (std::holds_alternative<Marked>(event) || std::holds_alternative<TimedOut>(event)) {
    EXPECT_TRUE(watched.renders) << what;
    ++watched.marks;
  } else if (std::holds_alternative<Rated>(event)) {
    EXPECT_EQ(watched.marks, 2) << what << ": a mark was skipped, or made twice";
    EXPECT_TRUE(watched.rated.insert(watched.state.step - 4).second) << what << ": rated twice";
  }
  const std::vector<std::string> effects = names_of(transition.effects);
  for (const std::string& effect : effects) {
    if (effect == "StartRendering") {
      EXPECT_FALSE(watched.renders) << what;
      watched.renders = true;
      watched.marks = 0;
    } else if (effect == "StopRendering") {
      EXPECT_TRUE(watched.renders) << what;
      watched.renders = false;
    }
  }
  const std::string question = question_in(transition.state.phase);
  const bool is_asked = std::count(effects.begin(), effects.end(), question) == 1;
  const bool has_changed = transition.state.phase != watched.state.phase || is_resumed;
  EXPECT_TRUE(is_asked || question.empty() || !has_changed) << what;
  EXPECT_EQ(std::count(effects.begin(), effects.end(), "AcknowledgeMark"),
            std::holds_alternative<Marked>(event) ? 1 : 0)
      << what;
  watched.state = transition.state;
  const Phase phase = watched.state.phase;
  EXPECT_EQ(watched.renders,
            phase == Phase::armed || phase == Phase::marking || phase == Phase::rating)
      << what;
  return watched;
}

/// The events that are possible whatever a session is waiting for.
bool is_always_allowed(const Event& event) {
  return std::holds_alternative<Interrupted>(event) || std::holds_alternative<NoteWritten>(event) ||
         std::holds_alternative<Withdrawn>(event) || std::holds_alternative<Excluded>(event);
}

/// The phases that an event may come in; the procedure, in its order.
bool belongs_to(const Event& event, Phase phase) {
  using enum Phase;
  static const std::map<std::string, std::set<Phase>> phases = {
      {"session_started", {created}},
      {"consent_given", {consent}},
      {"questionnaire_answered", {questionnaire}},
      {"gaze_validated", {validation}},
      {"reaction_pressed", {reaction}},
      {"object_chosen", {choosing_object}},
      {"trial_started", {ready}},
      {"first_frame_presented", {armed}},
      {"marked", {marking}},
      {"timed_out", {marking}},
      {"rated", {rating}},
      {"retime_requested", {marking, rating}},
      {"pause_requested",
       {consent, questionnaire, validation, reaction, choosing_object, ready, armed, marking,
        rating}},
      {"resumed", {paused, interrupted}},
      {"end_undone", {withdrawn, excluded}},
      {"consent_asked", {paused, interrupted}}};
  const auto found = phases.find(name_of(event));
  return is_always_allowed(event) || (found != phases.end() && found->second.contains(phase));
}

/// Whether what an event says is wrong where it may come.
bool is_wrong(const Event& event, const SessionState& state) {
  if (const auto* form = std::get_if<QuestionnaireAnswered>(&event)) {
    return form->questionnaire != (state.step == 1 ? "background" : "debrief");
  }
  if (const auto* chosen = std::get_if<ObjectChosen>(&event)) {
    return chosen->object.empty();
  }
  if (std::holds_alternative<ConsentAsked>(event)) {
    return state.step == 0 || state.resumes_at == Phase::consent;
  }
  if (const auto* marked = std::get_if<Marked>(&event)) {
    return marked->time < state.last_mark;
  }
  if (const auto* timed_out = std::get_if<TimedOut>(&event)) {
    return timed_out->time < state.last_mark;
  }
  if (const auto* rated = std::get_if<Rated>(&event)) {
    return rated->answers != std::vector<Answer>{{"artifacts", 5.0}};
  }
  return false;
}

class ModelCheck : public testing::Test {
 protected:
  ModelCheck() {
    reach({});
    while (!waiting_.empty() && reached_.size() < max_states) {
      const Watched watched = waiting_.back();
      waiting_.pop_back();
      if (watched.state.attempt <= max_attempts) {
        leave(watched);
      }
    }
  }

  void reach(const Watched& watched) {
    if (reached_.insert(watched).second) {
      waiting_.push_back(watched);
    }
  }

  void leave(const Watched& watched) {
    for (const Event& event : every_event()) {
      const auto transition = step(whole_procedure(), watched.state, event);
      const bool may_follow = !watched.state.is_over() || std::holds_alternative<EndUndone>(event);
      const bool expected =
          may_follow && belongs_to(event, watched.state.phase) && !is_wrong(event, watched.state);
      EXPECT_EQ(transition.has_value(), expected) << describe(watched, event);
      if (transition) {
        const Watched next = watch(watched, event, *transition);
        came_from_[next].push_back(watched);
        reach(next);
      }
    }
  }

  /// The states from which a way leads to one that is completed.
  std::set<Watched> can_complete() const {
    std::set<Watched> found;
    std::vector<Watched> waiting;
    for (const Watched& watched : reached_) {
      if (watched.state.phase == Phase::completed) {
        waiting.push_back(watched);
      }
    }
    while (!waiting.empty()) {
      const Watched watched = waiting.back();
      waiting.pop_back();
      if (found.insert(watched).second && came_from_.contains(watched)) {
        const std::vector<Watched>& before = came_from_.at(watched);
        waiting.insert(waiting.end(), before.begin(), before.end());
      }
    }
    return found;
  }

  std::set<Watched> reached_;
  std::map<Watched, std::vector<Watched>> came_from_;
  std::vector<Watched> waiting_;
};

TEST_F(ModelCheck, EveryEventInEveryState) {
  std::set<Phase> phases;
  for (const Watched& watched : reached_) {
    phases.insert(watched.state.phase);
  }
  EXPECT_EQ(phases.size(), 16U) << "every phase was reached";
  EXPECT_GT(reached_.size(), 300U);
  EXPECT_LT(reached_.size(), max_states);
}

TEST_F(ModelCheck, ThereAreNoDeadEnds) {
  const std::set<Watched> complete = can_complete();
  for (const Watched& watched : reached_) {
    if (!watched.state.is_over() && watched.state.attempt <= max_attempts) {
      EXPECT_TRUE(complete.contains(watched))
          << name_of(watched.state.phase) << " of step " << watched.state.step;
    }
  }
}

TEST_F(ModelCheck, WhoeverIsThroughHasDoneEverything) {
  int completed = 0;
  for (const Watched& watched : reached_) {
    if (watched.state.phase == Phase::completed) {
      ++completed;
      EXPECT_TRUE(watched.consented && watched.passed);
      EXPECT_EQ(watched.forms, (std::set<std::string>{"background", "debrief"}));
      EXPECT_EQ(watched.presses, 2);
      EXPECT_EQ(watched.rated, (std::set<std::size_t>{0, 1}));
    }
  }
  EXPECT_GT(completed, 0);
}

TEST_F(ModelCheck, TimingsAreCountedWithAttemptsButOnlyWhenRetimed) {
  for (const Watched& watched : reached_) {
    EXPECT_LE(watched.state.timing, watched.state.attempt);
    EXPECT_GE(watched.state.timing, 1);
  }
}

}  // namespace
}  // namespace foveola::study
