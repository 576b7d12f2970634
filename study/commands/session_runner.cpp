#include "study/commands/session_runner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/film/film_hash.h"
#include "study/commands/gaze_validation.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// A simulated participant looks this often. People integrate over about as long, and each look
/// costs as much as tracing several frames.
constexpr double glance_interval_s = 0.1;

/// Until a participant is ready for a trial: head and eye have turned to the object.
constexpr double settling_s = 1.0;

std::uint64_t frames_per_glance(const MachineModel& machine) {
  return static_cast<std::uint64_t>(
      std::max(1L, std::lround(glance_interval_s * machine.frame_rate_hz)));
}

bool stops_rendering(const std::vector<Effect>& effects) {
  return std::any_of(effects.begin(), effects.end(), [](const Effect& effect) {
    return std::holds_alternative<StopRendering>(effect);
  });
}

const OfferedObject& object_named(const std::vector<OfferedObject>& objects,
                                  const std::string& name) {
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&](const OfferedObject& object) { return object.name == name; });
  if (found == objects.end()) {
    throw Error(name, "is not among the scene's objects any more",
                "go on with the scene as it was");
  }
  return *found;
}

}  // namespace

SessionRunner::SessionRunner(const SessionSetting& setting, const Plan& plan, std::int64_t session,
                             Participant& participant)
    : setting_(setting),
      plan_(plan),
      procedure_(procedure_of(setting.protocol, plan)),
      session_(session),
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
    occasion_start_ = std::max(occasion_start_, logged.time);
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
    feed(setting_.stop.stop_requested() ? Event(Interrupted{}) : next_event());
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
  if (log_ && stops_rendering(next->effects)) {
    keep_frames();  // first: whatever an event has ended is whole, whenever the program dies
  }
  setting_.store.record_event(session_, time_of(event, now()), event, state_, next->state);
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
  attempt_ = {.trial = trial_index(), .number = state_.attempt};
  preview_.emplace(stage(), setting_.protocol, trial(), seeds, participant_, correction_, clock_,
                   setting_.workers);
  log_.emplace(sink_to(setting_.store, session_, attempt_.trial, attempt_.number));
}

void SessionRunner::keep_frames() {
  log_->finish();
  if (log_->frames() > 0) {
    setting_.store.record_film_hash(
        session_, attempt_.trial, attempt_.number,
        {.frame = log_->frames() - 1, .sha256 = film_sha256(preview_->film())});
  }
}

void SessionRunner::stop_rendering() {
  outcome_.samples += preview_->film().total_samples();
  outcome_.non_finite += preview_->non_finite();
  log_.reset();
  preview_.reset();
}

Event SessionRunner::answer_questionnaire() {
  const auto& asked = std::get<QuestionnaireStep>(procedure_.agenda[state_.step]);
  const Questionnaire& form = questionnaire_of(setting_.protocol, asked.questionnaire);
  return QuestionnaireAnswered{.questionnaire = form.id,
                               .answers = participant_.answer(form.id, form.questions)};
}

Event SessionRunner::validate() {
  begin_occasion(seed_of_step(SeedPurpose::conduct));
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
  const std::vector<OfferedObject>& objects = stage().objects();
  return ObjectChosen{objects[participant_.choose_object(trial().scene, objects)].name};
}

Event SessionRunner::start_trial() {
  setting_.on_trial(trial_index());
  begin_occasion(seed_of_trial(SeedPurpose::conduct));
  participant_.turn_to(trial().scene, object_named(stage().objects(), state_.object), clock_.now());
  clock_.advance(nanoseconds_from_seconds(settling_s));
  return TrialStarted{};
}

Event SessionRunner::present_first_frame() {
  begin(task_of_mark());
  show_frame();
  return FirstFramePresented{now()};
}

Event SessionRunner::wait_for_mark() {
  if (state_.mark > 0) {
    begin(task_of_mark());
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
    show_frame();
  }
  const Nanoseconds mark = occasion_start_ + *pressed_;
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
    show_frame();
  }
  ++outcome_.trials;
  return Rated{participant_.rate(setting_.protocol.ratings)};
}

void SessionRunner::begin_occasion(std::uint32_t conduct) {
  occasion_start_ = now();
  clock_ = VirtualClock();
  participant_.begin_occasion(conduct);
}

void SessionRunner::begin(Task task) {
  pressed_.reset();
  participant_.begin(task, clock_.now());
}

void SessionRunner::show_frame() {
  const bool is_glance = log_->frames() % frames_per_glance(setting_.protocol.machine) == 0;
  FrameRow row = frame_row(preview_->next_frame());
  row.time += occasion_start_;
  row.presented = now();
  std::vector<GazeSample> arrived = preview_->arrived_gaze();
  for (GazeSample& sample : arrived) {
    sample.time += occasion_start_;
  }
  log_->add(row, arrived);
  if (is_glance) {
    const std::optional<Nanoseconds> press =
        participant_.see({.image = preview_->present(),
                          .viewport = preview_->viewport(),
                          .gaze = participant_.gaze(clock_.now()),
                          .presented = clock_.now()});
    pressed_ = pressed_ ? pressed_ : press;
  }
}

Task SessionRunner::task_of_mark() const {
  return setting_.protocol.marks[state_.mark].id == "outline" ? Task::mark_outline
                                                              : Task::mark_material;
}

std::uint32_t SessionRunner::seed_of_trial(SeedPurpose purpose) const {
  return trial_seed(setting_.seed, purpose, setting_.protocol, trial(), state_.timing);
}

std::uint32_t SessionRunner::seed_of_step(SeedPurpose purpose) const {
  return derive_seed(setting_.seed, purpose,
                     {static_cast<int>(state_.step), state_.validations_left, state_.presses_left});
}

}  // namespace foveola::study
