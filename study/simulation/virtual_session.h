// A session of a simulated participant in virtual time: ports by which the driver gets every answer
// at once.
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
#include "study/participant/participant.h"
#include "study/session/session.h"
#include "study/simulation/trial_attempt.h"
#include "study/stage/scene_stage.h"
#include "study/stage/seeds.h"

namespace foveola::study {

/// What a session needs and does not own.
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

/// Runs one session until it is completed, refused by the protocol's gate, withdrawn from, or
/// interrupted because a stop was requested.
class VirtualSession final : private ClockPort, private DisplayPort, private InputPort {
 public:
  /// position: where the session, which is not over, goes on. All that is referred to must outlive
  /// it.
  VirtualSession(const SessionSetting& setting, const Plan& plan, Participant& participant,
                 const SessionPosition& position);

  SessionOutcome run() { return driver_.run(setting_.stop); }

 private:
  class RunningAttempt;

  Nanoseconds now() const override { return attempt_start_ + clock_.now(); }

  // Questions and acknowledgements are words on a screen and sounds; a simulated participant is
  // asked directly.
  void follow(const DurableEvent& /*event*/) override {}
  void carry_out(const Effect& /*effect*/) override {}
  std::unique_ptr<AttemptPort> begin_attempt() override;
  Nanoseconds show() override { return now(); }

  void act(SessionDriver& driver) override;
  std::optional<Nanoseconds> next_press() const override { return pressed_; }
  void answer_questionnaire();
  void validate();
  void press();
  void choose_object();
  void start_trial();
  void mark();
  void rate();

  /// Returns whether the participant ends the session here.
  bool withdraws();
  /// The attempt's clock starts anew.
  void restart(const Attempt& attempt);
  /// Unless the participant is at it: looks for something else, as the `index`-th task of the
  /// attempt.
  void begin(Task task, std::size_t index);

  const SessionState& state() const { return driver_.state(); }
  const SceneStage& stage() const { return *setting_.stages.at(driver_.trial().scene); }
  std::uint32_t seed_of_trial(SeedPurpose purpose) const;

  SessionSetting setting_;
  const Plan& plan_;
  Participant& participant_;
  /// The session's clock is at attempt_start_ when the attempt's, clock_, is at 0. What a
  /// participant sees and does is a matter of the latter, to the last bit.
  Nanoseconds attempt_start_;
  VirtualClock clock_;
  TrialAttempt* attempt_ = nullptr;  ///< while a trial is rendered
  std::optional<std::size_t> task_;  ///< index of the mark that is looked for; their count: rating
  std::optional<Nanoseconds> pressed_;  ///< the key, by the session's clock, for the task
  SessionDriver driver_;
};

}  // namespace foveola::study
