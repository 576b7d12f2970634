#include "study/commands/session_runner.h"

#include <cmath>
#include <stdexcept>

#include "study/commands/gaze_validation.h"

namespace foveola::study {
namespace {

/// A simulated participant looks this often. People integrate over about as long, and each look
/// costs as much as tracing several frames.
constexpr double glance_interval_s = 0.1;

/// From the choice of an object until rendering begins: head and eye have turned to it.
constexpr double settling_s = 1.0;

std::uint64_t frames_per_glance(const MachineModel& machine) {
  return static_cast<std::uint64_t>(
      std::max(1L, std::lround(glance_interval_s * machine.frame_rate_hz)));
}

/// When an event happened: a mark carries its own time.
Nanoseconds time_of(const Event& event, Nanoseconds now) {
  return std::visit(
      [now](const auto& e) {
        if constexpr (requires { e.time; }) {
          return e.time;
        } else {
          return now;
        }
      },
      event);
}

}  // namespace

SessionRunner::SessionRunner(const SessionSetting& setting, const Plan& plan, std::int64_t session,
                             Participant& participant)
    : setting_(setting), plan_(plan), session_(session), participant_(participant) {}

SessionOutcome SessionRunner::run() {
  while (!state_.is_over()) {
    feed(setting_.stop.stop_requested() ? Event(Interrupted{}) : next_event());
  }
  outcome_.phase = state_.phase;
  outcome_.trials = state_.trial;
  outcome_.duration = clock_.now();
  return outcome_;
}

Event SessionRunner::next_event() {
  switch (state_.phase) {
    case Phase::created:
      return start();
    case Phase::validation:
      return validate();
    case Phase::background:
      return answer_background();
    case Phase::choosing_object:
      return choose_object();
    case Phase::armed:
      return present_first_frame();
    case Phase::outline:
    case Phase::material:
      return wait_for_mark();
    case Phase::rating:
      return rate();
    case Phase::completed:
    case Phase::interrupted:
    case Phase::withdrawn:
    case Phase::refused:
      break;
  }
  throw std::logic_error(std::string("nothing follows the phase ") + name_of(state_.phase));
}

void SessionRunner::feed(const Event& event) {
  std::optional<Transition> next = step(plan_, state_, event);
  if (!next) {
    throw std::logic_error(std::string("the event ") + name_of(event) +
                           " is not allowed in the phase " + name_of(state_.phase));
  }
  setting_.store.record_event(session_, time_of(event, clock_.now()), event, state_, next->state);
  state_ = std::move(next->state);
  for (const Effect& effect : next->effects) {
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
  preview_.emplace(stage(), setting_.protocol, trial().method,
                   setting_.seeds(trial(), state_.attempt), participant_, correction_, clock_,
                   setting_.workers);
  log_.emplace(setting_.store, session_, state_.trial, state_.attempt);
  frames_shown_ = 0;
}

void SessionRunner::stop_rendering() {
  log_->finish();
  outcome_.samples += preview_->samples();
  outcome_.non_finite += preview_->non_finite();
  log_.reset();
  preview_.reset();
}

Event SessionRunner::start() const {
  const std::optional<ValidationSettings>& validation = setting_.protocol.tracker.validation;
  return SessionStarted{.validations = validation ? validation->attempts : 0};
}

Event SessionRunner::validate() {
  const std::optional<GazeValidated> validated = validate_gaze(
      setting_.protocol, participant_, setting_.validation_seed, clock_, setting_.stop);
  if (!validated) {
    return Interrupted{};
  }
  correction_ = correction_after(*validated);
  return *validated;
}

Event SessionRunner::answer_background() {
  return BackgroundAnswered{participant_.answer(setting_.protocol.background)};
}

Event SessionRunner::choose_object() {
  setting_.on_trial(state_.trial);
  const std::vector<OfferedObject>& objects = stage().objects();
  const std::size_t choice = participant_.choose_object(trial().scene, objects, clock_.now());
  clock_.advance(nanoseconds_from_seconds(settling_s));
  return ObjectChosen{objects[choice].name};
}

Event SessionRunner::present_first_frame() {
  participant_.begin(Task::mark_outline, clock_.now());
  show_frame();
  return FirstFramePresented{clock_.now()};
}

Event SessionRunner::wait_for_mark() {
  const bool outline = state_.phase == Phase::outline;
  if (!outline) {
    participant_.begin(Task::mark_material, clock_.now());
  }
  const Nanoseconds deadline =
      state_.first_frame + nanoseconds_from_seconds(setting_.protocol.timing.mark_timeout_s);
  std::optional<Nanoseconds> pressed;
  while (!pressed || clock_.now() < *pressed) {
    if (clock_.now() >= deadline) {
      return TimedOut{deadline};
    }
    if (setting_.stop.stop_requested()) {
      return Interrupted{};
    }
    const std::optional<Nanoseconds> press = show_frame();
    pressed = pressed ? pressed : press;
  }
  return outline ? Event(OutlineMarked{*pressed}) : Event(MaterialMarked{*pressed});
}

Event SessionRunner::rate() {
  participant_.begin(Task::look_around, clock_.now());
  const Nanoseconds end =
      clock_.now() + nanoseconds_from_seconds(setting_.protocol.timing.rating_s);
  while (clock_.now() < end) {
    if (setting_.stop.stop_requested()) {
      return Interrupted{};
    }
    show_frame();
  }
  return ArtifactsRated{participant_.rate_artifacts()};
}

std::optional<Nanoseconds> SessionRunner::show_frame() {
  const FrameReport report = preview_->next_frame();
  log_->add(report, preview_->arrived_gaze());
  const bool glance = frames_shown_++ % frames_per_glance(setting_.protocol.machine) == 0;
  if (!glance) {
    return std::nullopt;
  }
  const RgbImage& image = preview_->present();
  return participant_.see({.image = image,
                           .viewport = preview_->viewport(),
                           .gaze = participant_.gaze(clock_.now()),
                           .presented = clock_.now()});
}

}  // namespace foveola::study
