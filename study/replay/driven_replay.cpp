#include "study/replay/driven_replay.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "study/driver/session_driver.h"
#include "study/replay/compared_record.h"

namespace foveola::study {
namespace {

/// An attempt that is not shown: frames come when the driver waits for them.
class UnseenAttempt final : public AttemptPort {
 public:
  Nanoseconds show(Nanoseconds until) override { return until; }
  std::uint64_t samples() const override { return 0; }
  std::uint64_t non_finite() const override { return 0; }
};

/// One run of the program that recorded the session, until its interruption or death.
class ReplayedRun final : private ClockPort, private DisplayPort, private InputPort {
 public:
  ReplayedRun(const DrivenRecord& record, const DrivenSession& run, ComparedRecord& compared,
              const std::stop_token& stop)
      : record_(record),
        compared_(compared),
        stop_(stop),
        driver_(run, *this, *this, *this, compared) {}

  /// Returns whether it ended with an interruption, as recorded: a stop requested now is not one.
  bool run() { return driver_.run({}).phase == Phase::interrupted; }

 private:
  Nanoseconds now() const override { return std::max(compared_.time(), shown_); }

  void follow(const DurableEvent& /*event*/) override {}
  void carry_out(const Effect& effect) override {
    if (std::holds_alternative<StopRendering>(effect)) {
      attempt_ = nullptr;
    }
  }
  std::unique_ptr<AttemptPort> begin_attempt() override {
    std::unique_ptr<AttemptPort> attempt = record_.begin_attempt({.trial = driver_.trial_index(),
                                                                  .attempt = driver_.seen().attempt,
                                                                  .timing = driver_.seen().timing});
    if (!attempt) {
      attempt = std::make_unique<UnseenAttempt>();
    }
    attempt_ = attempt.get();
    return attempt;
  }
  Nanoseconds show() override { return now(); }
  void end_frame(Nanoseconds shown) override { shown_ = shown; }

  void pass_input(SessionDriver& driver) override {
    if (stop_.stop_requested()) {
      driver.leave();
    } else if (compared_.is_at_end()) {
      leave_attempt();
      driver.leave();
    } else if (!waits_for(compared_.next().event) && !make(compared_.next().event)) {
      compared_.differ(
          fmt::format("the replayed session is {} and cannot make it", name_of(phase())));
      driver.leave();
    }
  }

  Phase phase() const { return driver_.state().phase; }

  /// Returns whether the driver makes the event by itself in time.
  bool waits_for(const Event& event) const {
    return (std::holds_alternative<FirstFramePresented>(event) && phase() == Phase::armed) ||
           (std::holds_alternative<TimedOut>(event) && phase() == Phase::marking);
  }

  /// Makes the event, or another one in its place. Returns false if there is none.
  bool make(const Event& event) {
    shown_ = Nanoseconds(0);
    const std::size_t before = compared_.made();
    if (std::holds_alternative<Interrupted>(event)) {
      driver_.interrupt();
    } else if (const auto* marked = std::get_if<Marked>(&event)) {
      driver_.mark(marked->time);
    } else {
      driver_.record_event(event);
    }
    return compared_.made() != before;
  }

  /// Leaves an attempt in which the program died, after its recorded part has been shown.
  void leave_attempt() {
    if (attempt_ != nullptr) {
      attempt_->complete_record();
    }
  }

  const DrivenRecord& record_;
  ComparedRecord& compared_;
  std::stop_token stop_;
  AttemptPort* attempt_ = nullptr;  ///< the driver's, while it lasts
  Nanoseconds shown_{0};  ///< session clock: time of the newest frame that the driver waited for
  SessionDriver driver_;
};

Protocol protocol_of_run(const DrivenRecord& record, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (const std::optional<Amendment> amendment = amendment_in(note)) {
      return record.amended(*amendment);
    }
  }
  return record.protocol;
}

}  // namespace

std::string replay_events(const DrivenRecord& record, const std::stop_token& stop) {
  const RecordedSession& session = record.session;
  const Procedure procedure = procedure_of(record.protocol, session.plan);
  ComparedRecord compared(session.events);
  bool goes_on = true;
  while (goes_on && !compared.is_at_end() && !stop.stop_requested()) {
    const std::vector<LoggedEvent> before(
        session.events.begin(),
        session.events.begin() + static_cast<std::ptrdiff_t>(compared.made()));
    const std::vector<std::string> notes = compared.next_notes();
    const Protocol protocol = protocol_of_run(record, notes);
    const DrivenSession run{
        .protocol = protocol,
        .plan = session.plan,
        .position = position_after(procedure, before, "participant " + session.known.participant),
        .notes = notes};
    goes_on = ReplayedRun(record, run, compared, stop).run();
  }
  return compared.difference();
}

}  // namespace foveola::study
