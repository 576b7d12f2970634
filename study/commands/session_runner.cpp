#include "study/commands/session_runner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/commands/gaze_validation.h"
#include "study/stage/conduct.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

bool stops_rendering(const std::vector<Effect>& effects) {
  return std::any_of(effects.begin(), effects.end(), [](const Effect& effect) {
    return std::holds_alternative<StopRendering>(effect);
  });
}

}  // namespace

SessionRunner::SessionRunner(const SessionSetting& setting, const Plan& plan,
                             Participant& participant)
    : setting_(setting),
      plan_(plan),
      procedure_(procedure_of(setting.protocol, plan)),
      participant_(participant) {}

void SessionRunner::resume_after(const std::vector<LoggedEvent>& events) {
  for (const LoggedEvent& logged : events) {
    std::optional<Transition> next = step(procedure_, state_, logged.event);
    if (!next) {
      throw Error("the record",
                  fmt::format("{} cannot have happened in the phase {}", name_of(logged.event),
                              name_of(state_.phase)),
                  "foveola study verify says what is wrong with it");
    }
    state_ = std::move(next->state);
    attempt_start_ = std::max(attempt_start_, logged.time);
    if (const auto* validated = std::get_if<GazeValidated>(&logged.event)) {
      correction_ = correction_after(*validated);
    }
  }
  if (state_.phase == Phase::created) {
    return;
  }
  if (state_.phase != Phase::interrupted) {
    record(Interrupted{});  // which the program that died could not say
  }
  feed(Resumed{});
}

SessionOutcome SessionRunner::run() {
  const Nanoseconds start = now();
  while (!state_.is_over() && state_.phase != Phase::interrupted) {
    const Event event = setting_.stop.stop_requested() ? Event(Interrupted{}) : next_event();
    feed(event);
    if (std::holds_alternative<Marked>(event) && participant_.wants_retime()) {
      feed(RetimeRequested{});
    }
  }
  outcome_.phase = state_.phase;
  outcome_.duration = now() - start;
  return outcome_;
}

Event SessionRunner::next_event() {
  switch (state_.phase) {
    case Phase::created:
      return SessionStarted{};
    case Phase::consent:
      return ConsentGiven{};
    case Phase::questionnaire:
      return answer_questionnaire();
    case Phase::validation:
      return validate();
    case Phase::reaction:
      return press();
    case Phase::choosing_object:
      return choose_object();
    case Phase::ready:
      return start_trial();
    case Phase::armed:
      return present_first_frame();
    case Phase::marking:
      return wait_for_mark();
    case Phase::rating:
      return rate();
    case Phase::paused:
      return Resumed{};
    case Phase::interrupted:
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      break;
  }
  throw std::logic_error(std::string("nothing follows the phase ") + name_of(state_.phase));
}

std::vector<Effect> SessionRunner::record(const Event& event) {
  std::optional<Transition> next = step(procedure_, state_, event);
  if (!next) {
    throw std::logic_error(std::string("the event ") + name_of(event) +
                           " is not allowed in the phase " + name_of(state_.phase));
  }
  if (attempt_ && stops_rendering(next->effects)) {
    attempt_->keep();  // first: whatever an event has ended is whole, whenever the program dies
  }
  setting_.recorder
      .record(EventEntry{
          .time = time_of(event, now()), .event = event, .before = state_, .after = next->state})
      .get();
  state_ = std::move(next->state);
  return std::move(next->effects);
}

void SessionRunner::feed(const Event& event) {
  for (const Effect& effect : record(event)) {
    carry_out(effect);
  }
}

void SessionRunner::carry_out(const Effect& effect) {
  // Questions and acknowledgements are words on a screen and sounds; a simulated participant is
  // asked directly, when the answer is waited for.
  if (std::holds_alternative<StartRendering>(effect)) {
    start_rendering();
  } else if (std::holds_alternative<StopRendering>(effect)) {
    stop_rendering();
  }
}

void SessionRunner::start_rendering() {
  const TrialSeeds seeds{.tracker = seed_of_trial(SeedPurpose::tracker),
                         .rendering = seed_of_trial(SeedPurpose::rendering)};
  attempt_ = setting_.make_attempt({.stage = stage(),
                                    .protocol = setting_.protocol,
                                    .trial = trial(),
                                    .object = object_named(stage().objects(), state_.object),
                                    .seeds = seeds,
                                    .participant = participant_,
                                    .correction = correction_,
                                    .clock = clock_,
                                    .attempt_start = attempt_start_,
                                    .recorder = setting_.recorder,
                                    .key = {.trial = trial_index(), .attempt = state_.attempt}});
}

void SessionRunner::stop_rendering() {
  outcome_.samples += attempt_->samples();
  outcome_.non_finite += attempt_->non_finite();
  attempt_.reset();
}

Event SessionRunner::answer_questionnaire() {
  const auto& asked = std::get<QuestionnaireStep>(procedure_.agenda[state_.step]);
  const Questionnaire& form = questionnaire_of(setting_.protocol, asked.questionnaire);
  return QuestionnaireAnswered{.questionnaire = form.id,
                               .answers = participant_.answer(form.id, form.questions)};
}

Event SessionRunner::validate() {
  begin_attempt({.conduct = seed_of_step(SeedPurpose::conduct), .trials_before = 0});
  const std::optional<GazeValidated> validated = validate_gaze(
      setting_.protocol, participant_, seed_of_step(SeedPurpose::tracker), clock_, setting_.stop);
  if (!validated) {
    return Interrupted{};
  }
  correction_ = correction_after(*validated);
  return *validated;
}

Event SessionRunner::press() {
  const ReactionSettings& reaction = *setting_.protocol.reaction;
  Pcg32 random(seed_of_step(SeedPurpose::waiting));
  const double wait_s = reaction.shortest_wait_s +
                        (reaction.longest_wait_s - reaction.shortest_wait_s) * random.uniform();
  clock_.advance(nanoseconds_from_seconds(wait_s));
  const Nanoseconds shown = now();
  clock_.advance(participant_.react(seed_of_step(SeedPurpose::conduct)));
  return ReactionPressed{.shown = shown, .time = now()};
}

Event SessionRunner::choose_object() {
  if (participant_.wants_to_withdraw(trials_before())) {
    return Withdrawn{};
  }
  const std::vector<OfferedObject>& objects = stage().objects();
  return ObjectChosen{objects[participant_.choose_object(trial().scene, objects)].name};
}

Event SessionRunner::start_trial() {
  if (participant_.wants_to_withdraw(trials_before())) {
    return Withdrawn{};
  }
  setting_.on_trial(trial_index());
  begin_attempt({.conduct = seed_of_trial(SeedPurpose::conduct), .trials_before = trials_before()});
  participant_.turn_to(trial().scene, object_named(stage().objects(), state_.object), clock_.now());
  clock_.advance(nanoseconds_from_seconds(settling_s));
  return TrialStarted{};
}

Event SessionRunner::present_first_frame() {
  begin(task_of(setting_.protocol.marks[state_.mark]));
  show(clock_.now());
  return FirstFramePresented{now()};
}

Event SessionRunner::wait_for_mark() {
  if (state_.mark > 0) {
    begin(task_of(setting_.protocol.marks[state_.mark]));
  }
  const Nanoseconds deadline =
      state_.first_frame + nanoseconds_from_seconds(mark_timeout_s(setting_.protocol, trial()));
  while (!pressed_ || clock_.now() < *pressed_) {
    if (now() >= deadline) {
      return TimedOut{deadline};
    }
    if (setting_.stop.stop_requested()) {
      return Interrupted{};
    }
    const Nanoseconds end = deadline - attempt_start_;
    show(pressed_ ? std::min(*pressed_, end) : end);
  }
  const Nanoseconds mark = attempt_start_ + *pressed_;
  return mark <= deadline ? Event(Marked{mark}) : Event(TimedOut{deadline});
}

Event SessionRunner::rate() {
  begin(Task::look_around);
  const Timing timing = settings_of(setting_.protocol, trial().scene, trial().method).timing;
  const Nanoseconds end = now() + nanoseconds_from_seconds(timing.rating_s);
  while (now() < end) {
    if (setting_.stop.stop_requested()) {
      return Interrupted{};
    }
    show(end - attempt_start_);
  }
  ++outcome_.trials;
  return Rated{participant_.rate(setting_.protocol.ratings)};
}

void SessionRunner::begin_attempt(const Attempt& attempt) {
  attempt_start_ = now();
  clock_ = VirtualClock();
  participant_.begin_attempt(attempt);
}

void SessionRunner::begin(Task task) {
  pressed_.reset();
  participant_.begin(task, clock_.now());
  attempt_->begin(task);
}

void SessionRunner::show(Nanoseconds until) {
  const std::optional<Nanoseconds> press = attempt_->show(until);
  pressed_ = pressed_ ? pressed_ : press;
}

std::uint32_t SessionRunner::seed_of_trial(SeedPurpose purpose) const {
  return trial_seed(setting_.seed, purpose, setting_.protocol, trial(), state_.timing);
}

std::uint32_t SessionRunner::seed_of_step(SeedPurpose purpose) const {
  return derive_seed(setting_.seed, purpose,
                     {static_cast<int>(state_.step), state_.validations_left, state_.presses_left});
}

}  // namespace foveola::study
