// Runs a simulated participant's session in virtual time, with ports that answer at once.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "renderer/base/clock.h"
#include "study/design/plan.h"
#include "study/driver/session_driver.h"
#include "study/participant/conduct.h"
#include "study/participant/participant.h"
#include "study/session/session.h"
#include "study/simulation/trial_attempt.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"

namespace foveola::study {

/// Resources of a session.
struct SessionSetting {
  const Protocol& protocol;
  const SceneStages& stages;
  SessionRecorder& recorder;
  MakeAttempt make_attempt;
  SessionSeed seed;
  /// Called when a trial begins, with its index.
  std::function<void(std::size_t trial)> on_trial;
  std::stop_token stop;
};

/// Runs one session until it is completed, refused by the protocol's gate, withdrawn, or
/// interrupted because a stop was requested.
class VirtualSession final : private ClockPort,
                             private DisplayPort,
                             private InputPort,
                             private ParticipantActions {
 public:
  /// position: where the session, which is not over, resumes. Everything referred to must outlive
  /// it.
  VirtualSession(const SessionSetting& setting, const Plan& plan, Participant& participant,
                 const SessionPosition& position);

  SessionOutcome run() { return driver_.run(setting_.stop); }

 private:
  Nanoseconds now() const override { return attempt_start_ + clock_.now(); }

  // Questions and acknowledgements are texts and sounds; a simulated participant is asked directly.
  void follow(const DurableEvent& /*event*/) override {}
  void carry_out(const Effect& /*effect*/) override {}
  std::unique_ptr<AttemptPort> begin_attempt() override;
  Nanoseconds show() override { return now(); }

  void pass_input(SessionDriver& driver) override;
  std::optional<Nanoseconds> next_press() const override { return pressed_; }

  Participant& participant() override { return participant_; }
  void consent() override { driver_.record_event(consent_to(setting_.protocol)); }
  void hand_in(const Questionnaire& form, const std::vector<Answer>& answers) override;
  void validate_gaze(const Attempt& attempt) override;
  void react(std::uint32_t conduct) override;
  void withdraw() override { driver_.record_event(Withdrawn{}); }
  /// Resets the attempt's clock.
  void begin_attempt(const Attempt& attempt) override;
  void choose_object() override;
  void start_trial() override;
  void ask_for_retime() override { driver_.record_event(RetimeRequested{}); }
  void begin_task(Task task) override;
  void look_for_mark() override;
  void look_around() override {}
  void rate() override {
    driver_.record_event(Rated{participant_.rate(setting_.protocol.ratings)});
  }
  void resume() override { driver_.record_event(Resumed{}); }
  void leave() override { driver_.leave(); }

  const SessionState& state() const { return driver_.state(); }
  const SceneStage& stage() const { return *setting_.stages.at(driver_.trial().scene); }
  std::uint32_t seed_of_trial(SeedPurpose purpose) const;

  SessionSetting setting_;
  Participant& participant_;
  SimulatedConduct conduct_;
  /// The session's clock is at attempt_start_ when the attempt's, clock_, is at 0. A participant's
  /// behaviour depends on the latter only, to the last bit.
  Nanoseconds attempt_start_;
  VirtualClock clock_;
  TrialAttempt* attempt_ = nullptr;     ///< the last; the driver's, which it ends
  std::optional<Nanoseconds> pressed_;  ///< session clock: time of the task's key press
  SessionDriver driver_;
};

}  // namespace foveola::study
