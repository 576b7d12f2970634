#include "study/driver/session_driver.h"

#include <algorithm>
#include <utility>

#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

template <typename Kind>
bool is(const Effect& effect) {
  return std::holds_alternative<Kind>(effect);
}

}  // namespace

SessionDriver::SessionDriver(DrivenSession session, const ClockPort& clock, DisplayPort& display,
                             InputPort& input, SessionRecorder& recorder)
    : session_(std::move(session)),
      clock_(clock),
      display_(display),
      input_(input),
      log_(procedure_of(session_.protocol, session_.plan), session_.position.state, recorder),
      seen_(session_.position.state),
      correction_(session_.position.correction) {}

SessionOutcome SessionDriver::run(const std::stop_token& stop) {
  const Nanoseconds start = clock_.now();
  begin();
  carry_out_durable();
  while (!is_left_) {
    if (stop.stop_requested()) {
      interrupt();
    } else if (!take_turn()) {
      show();
    }
    carry_out_durable();
  }
  outcome_.phase = state().phase;
  outcome_.duration = clock_.now() - start;
  return outcome_;
}

void SessionDriver::begin() {
  if (state().phase != Phase::created) {
    if (state().is_over()) {
      record_event(EndUndone{});
    } else if (state().phase != Phase::interrupted) {
      record_event(Interrupted{});  // the last program died without recording it
    }
    write_notes();
    const std::string& agreed_to = session_.position.consent_sha256;
    if (!agreed_to.empty() && agreed_to != consent_to(session_.protocol).text_sha256) {
      record_event(ConsentAsked{});
    }
    record_event(Resumed{});
  }
  if (state().phase == Phase::created) {
    record_event(SessionStarted{});
    write_notes();
  }
}

void SessionDriver::write_notes() {
  for (const std::string& note : std::exchange(session_.notes, {})) {
    record_event(NoteWritten{note});
  }
}

bool SessionDriver::take_turn() {
  const std::uint64_t before = events_fed_;
  input_.pass_input(*this);
  if (events_fed_ == before) {
    follow_time();
  }
  return is_left_ || events_fed_ != before;
}

void SessionDriver::follow_time() {
  if (waits_in(Phase::marking) && clock_.now() >= deadline()) {
    record_event(TimedOut{deadline()});
  }
}

void SessionDriver::show() {
  if (is_to_render_ && !attempt_ && !has_effects_to_come()) {
    begin_attempt();
  }
  display_.begin_frame();
  const Nanoseconds shown = attempt_ ? attempt_->show(shown_until()) : display_.show();
  display_.end_frame(shown);
  if (attempt_ && waits_in(Phase::armed)) {
    record_event(FirstFramePresented{shown});
  }
}

Nanoseconds SessionDriver::shown_until() const {
  switch (state().phase) {
    case Phase::marking:
      return std::min(deadline(), input_.next_press().value_or(deadline()));
    case Phase::rating:
      return look_around_until_;
    default:
      return clock_.now();
  }
}

bool SessionDriver::record_event(const Event& event) {
  const Nanoseconds now = clock_.now();
  if (attempt_ && ends_attempt(event)) {
    attempt_->complete_record();
  }
  if (!log_.record_event(now, event)) {
    return false;
  }
  ++events_fed_;
  outcome_.trials += std::holds_alternative<Rated>(event) ? 1 : 0;
  return true;
}

bool SessionDriver::ends_attempt(const Event& event) const {
  const std::optional<Transition> next = step(procedure(), state(), event);
  return next && std::ranges::any_of(next->effects, is<StopRendering>);
}

bool SessionDriver::mark(Nanoseconds time) {
  if (state().phase != Phase::marking) {
    return false;
  }
  if (time > deadline()) {
    record_event(TimedOut{deadline()});
    return false;
  }
  return record_event(Marked{time});
}

void SessionDriver::interrupt() {
  leave();
  carry_out(log_.wait_for_all());
  record_event(Interrupted{});
  carry_out(log_.wait_for_all());
}

void SessionDriver::carry_out_durable() { carry_out(log_.take_durable()); }

void SessionDriver::carry_out(const std::vector<DurableEvent>& events) {
  for (const DurableEvent& durable : events) {
    seen_ = durable.after;
    if (const auto* validated = std::get_if<GazeValidated>(&durable.event)) {
      correction_ = correction_after(*validated);
    }
    display_.follow(durable);
    for (const Effect& effect : durable.effects) {
      carry_out(effect);
    }
  }
}

void SessionDriver::carry_out(const Effect& effect) {
  if (is<AskForRating>(effect)) {
    const Timing timing = settings_of(session_.protocol, trial().scene, trial().method).timing;
    look_around_until_ = clock_.now() + nanoseconds_from_seconds(timing.rating_s);
  } else if (is<StopRendering>(effect)) {
    end_attempt();
  }
  display_.carry_out(effect);
  if (is<StartRendering>(effect)) {
    is_to_render_ = true;
    begin_attempt();
  }
}

void SessionDriver::begin_attempt() { attempt_ = display_.begin_attempt(); }

void SessionDriver::end_attempt() {
  is_to_render_ = false;
  // There is no attempt if it was that of a program that died, or if it never began.
  if (attempt_) {
    outcome_.samples += attempt_->samples();
    outcome_.non_finite += attempt_->non_finite();
    attempt_.reset();
  }
}

std::size_t SessionDriver::trial_index() const { return trial_of(procedure(), seen_).value(); }

Nanoseconds SessionDriver::deadline() const {
  return state().first_frame + nanoseconds_from_seconds(mark_timeout_s(session_.protocol, trial()));
}

}  // namespace foveola::study
