#include "study/session/session.h"

#include <array>

namespace foveola::study {
namespace {

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
// NOLINTNEXTLINE(readability-identifier-naming): a deduction guide has its class's name.
Overloaded(Functions...)->Overloaded<Functions...>;

using Result = std::optional<Transition>;

SessionState at(Phase phase, std::size_t trial) {
  SessionState state;
  state.phase = phase;
  state.trial = trial;
  return state;
}

/// The next trial, or the end.
Transition begin_trial(const Plan& plan, std::size_t trial) {
  if (trial == plan.size()) {
    return {.state = at(Phase::completed, trial), .effects = {EndSession{}}};
  }
  return {.state = at(Phase::choosing_object, trial), .effects = {AskForObject{}}};
}

Transition end(SessionState state, Phase phase) {
  std::vector<Effect> effects;
  if (state.phase == Phase::outline || state.phase == Phase::material ||
      state.phase == Phase::rating || state.phase == Phase::armed) {
    effects.emplace_back(StopRendering{});
  }
  effects.emplace_back(EndSession{});
  state.phase = phase;
  return {.state = std::move(state), .effects = std::move(effects)};
}

Transition ask_background() {
  return {.state = at(Phase::background, 0), .effects = {AskBackground{}}};
}

Result start(const SessionState& state, const SessionStarted& event) {
  if (state.phase != Phase::created) {
    return std::nullopt;
  }
  if (event.validations == 0) {
    return ask_background();
  }
  SessionState validation = at(Phase::validation, 0);
  validation.validations_left = event.validations;
  return Transition{.state = std::move(validation), .effects = {ValidateGaze{}}};
}

Result validate_gaze(SessionState state, const GazeValidated& event) {
  if (state.phase != Phase::validation) {
    return std::nullopt;
  }
  if (event.passed) {
    return ask_background();
  }
  if (--state.validations_left == 0) {
    return end(std::move(state), Phase::refused);
  }
  return Transition{.state = std::move(state), .effects = {ValidateGaze{}}};
}

Result answer_background(const Plan& plan, const SessionState& state) {
  return state.phase == Phase::background ? Result(begin_trial(plan, 0)) : std::nullopt;
}

Result choose_object(SessionState state, const ObjectChosen& event) {
  if (state.phase != Phase::choosing_object || event.object.empty()) {
    return std::nullopt;
  }
  state.phase = Phase::armed;
  state.object = event.object;
  return Transition{.state = std::move(state), .effects = {StartRendering{}}};
}

Result present_first_frame(SessionState state, const FirstFramePresented& event) {
  if (state.phase != Phase::armed) {
    return std::nullopt;
  }
  state.phase = Phase::outline;
  state.first_frame = event.time;
  return Transition{.state = std::move(state), .effects = {}};
}

/// The outline mark, or its time-out.
Result end_outline(SessionState state, Nanoseconds time, std::vector<Effect> effects) {
  if (state.phase != Phase::outline || time < state.first_frame) {
    return std::nullopt;
  }
  state.phase = Phase::material;
  state.outline = time;
  return Transition{.state = std::move(state), .effects = std::move(effects)};
}

/// The material mark, or its time-out.
Result end_material(SessionState state, Nanoseconds time, std::vector<Effect> effects) {
  if (state.phase != Phase::material || time < state.outline) {
    return std::nullopt;
  }
  state.phase = Phase::rating;
  effects.emplace_back(AskForRating{});
  return Transition{.state = std::move(state), .effects = std::move(effects)};
}

Result time_out(const SessionState& state, const TimedOut& event) {
  return state.phase == Phase::outline ? end_outline(state, event.time, {})
                                       : end_material(state, event.time, {});
}

Result rate(const Plan& plan, const SessionState& state, const ArtifactsRated& event) {
  if (state.phase != Phase::rating || event.rating < 1 || event.rating > 5) {
    return std::nullopt;
  }
  Transition next = begin_trial(plan, state.trial + 1);
  next.effects.insert(next.effects.begin(), StopRendering{});
  return next;
}

Result retime(const SessionState& state) {
  if (state.phase != Phase::material && state.phase != Phase::rating) {
    return std::nullopt;
  }
  SessionState again = at(Phase::armed, state.trial);
  again.attempt = state.attempt + 1;
  again.object = state.object;
  return Transition{.state = std::move(again), .effects = {StopRendering{}, StartRendering{}}};
}

}  // namespace

const char* name_of(Phase phase) {
  constexpr std::array names = {"created",   "validation",  "background", "choosing_object",
                                "armed",     "outline",     "material",   "rating",
                                "completed", "interrupted", "withdrawn",  "refused"};
  return names.at(static_cast<std::size_t>(phase));
}

const char* name_of(const Event& event) {
  constexpr std::array names = {
      "session_started",       "gaze_validated",   "background_answered", "object_chosen",
      "first_frame_presented", "outline_marked",   "material_marked",     "timed_out",
      "artifacts_rated",       "retime_requested", "interrupted",         "withdrawn"};
  static_assert(names.size() == std::variant_size_v<Event>);
  return names.at(event.index());
}

std::optional<Transition> step(const Plan& plan, const SessionState& state, const Event& event) {
  if (state.is_over()) {
    return std::nullopt;
  }
  return std::visit(
      Overloaded{
          [&](const SessionStarted& e) { return start(state, e); },
          [&](const GazeValidated& e) { return validate_gaze(state, e); },
          [&](const BackgroundAnswered&) { return answer_background(plan, state); },
          [&](const ObjectChosen& e) { return choose_object(state, e); },
          [&](const FirstFramePresented& e) { return present_first_frame(state, e); },
          [&](const OutlineMarked& e) { return end_outline(state, e.time, {AcknowledgeMark{}}); },
          [&](const MaterialMarked& e) { return end_material(state, e.time, {AcknowledgeMark{}}); },
          [&](const TimedOut& e) { return time_out(state, e); },
          [&](const ArtifactsRated& e) { return rate(plan, state, e); },
          [&](const RetimeRequested&) { return retime(state); },
          [&](const Interrupted&) { return Result(end(state, Phase::interrupted)); },
          [&](const Withdrawn&) { return Result(end(state, Phase::withdrawn)); },
      },
      event);
}

}  // namespace foveola::study
