#include "study/participant/conduct.h"

#include "tests/matchers.h"
#include "tests/study/participant/fake_participant.h"
#include "tests/study/record/small_study.h"

namespace foveola::study {
namespace {

/// Writes down what is done.
class NotedActions final : public ParticipantActions {
 public:
  explicit NotedActions(Participant& participant) : participant_(participant) {}

  Participant& participant() override { return participant_; }
  void consent() override { done.emplace_back("consent"); }
  void hand_in(const Questionnaire& form, const std::vector<Answer>& /*answers*/) override {
    done.push_back("hand in " + form.id);
  }
  void validate_gaze(const Attempt& /*attempt*/) override { done.emplace_back("validate"); }
  void react(std::uint32_t /*conduct*/) override { done.emplace_back("react"); }
  void withdraw() override { done.emplace_back("withdraw"); }
  void begin_attempt(const Attempt& attempt) override {
    participant_.begin_attempt(attempt);
    done.emplace_back("begin attempt");
  }
  void choose_object() override { done.emplace_back("choose"); }
  void start_trial() override { done.emplace_back("start"); }
  void ask_for_retime() override { done.emplace_back("retime"); }
  void begin_task(Task task) override {
    done.push_back("begin task " + std::to_string(static_cast<int>(task)));
  }
  void look_for_mark() override { done.emplace_back("look for mark"); }
  void look_around() override { done.emplace_back("look around"); }
  void rate() override { done.emplace_back("rate"); }
  void resume() override { done.emplace_back("resume"); }
  void leave() override { done.emplace_back("leave"); }

  std::vector<std::string> done;

 private:
  Participant& participant_;
};

class SimulatedConductTest : public ::testing::Test {
 protected:
  SimulatedConductTest() {
    protocol_.timing = {.mark_timeout_s = 2.0, .rating_s = 0.5};
    const auto step =
        std::find_if(procedure_.agenda.begin(), procedure_.agenda.end(),
                     [](const AgendaStep& at) { return std::holds_alternative<TrialStep>(at); });
    state_.step = static_cast<std::size_t>(step - procedure_.agenda.begin());
  }

  /// What is done in this phase since the last call.
  std::vector<std::string> done_in(Phase phase, Nanoseconds now = {}) {
    state_.phase = phase;
    conduct_.perform_action(
        {.procedure = procedure_, .state = state_, .now = now, .look_around_until = ms(9000)},
        actions_);
    return std::exchange(actions_.done, {});
  }

  Protocol protocol_ = small_protocol();
  Plan plan_ = small_plan();
  Procedure procedure_ = procedure_of(protocol_, plan_);
  SessionState state_;
  FakeParticipant participant_;
  NotedActions actions_{participant_};
  SimulatedConduct conduct_{protocol_, plan_, {.seed = 5, .design_row = 0}};
};

TEST_F(SimulatedConductTest, AnAttemptAndItsTasksBeginOnce) {
  EXPECT_THAT(done_in(Phase::choosing_object), ElementsAre("begin attempt", "choose"));
  EXPECT_THAT(done_in(Phase::ready), ElementsAre("start"));
  EXPECT_THAT(done_in(Phase::armed), ElementsAre("begin task 0", "look for mark"));
  EXPECT_THAT(done_in(Phase::marking), ElementsAre("look for mark"));
  state_.mark = 1;
  EXPECT_THAT(done_in(Phase::marking), ElementsAre("begin task 1", "look for mark"));
  EXPECT_THAT(done_in(Phase::rating, ms(8999)), ElementsAre("begin task 2", "look around"));
  EXPECT_THAT(done_in(Phase::rating, ms(9000)), ElementsAre("look around", "rate"));
  state_.attempt = 2;
  EXPECT_THAT(done_in(Phase::ready), ElementsAre("begin attempt", "start"));
}

TEST_F(SimulatedConductTest, WhoWithdrawsBeginsNoAttempt) {
  participant_.withdraws_before = 0;
  EXPECT_THAT(done_in(Phase::choosing_object), ElementsAre("withdraw"));
  EXPECT_THAT(done_in(Phase::ready), ElementsAre("withdraw"));
}

TEST_F(SimulatedConductTest, OnlyAMarkThatWasMadeIsRegretted) {
  participant_.regrets = true;
  done_in(Phase::marking);
  state_.mark = 1;
  state_.first_frame = ms(1000);
  state_.last_mark = ms(2999);
  EXPECT_THAT(done_in(Phase::marking), ElementsAre("retime"));
  state_.last_mark = ms(3000);
  EXPECT_THAT(done_in(Phase::marking), ElementsAre("begin task 1", "look for mark"))
      << "it is right-censored";
}

TEST_F(SimulatedConductTest, NothingIsDoneBeforeTheStartAndWhileInterrupted) {
  EXPECT_THAT(done_in(Phase::created), IsEmpty());
  EXPECT_THAT(done_in(Phase::interrupted), IsEmpty());
  EXPECT_THAT(done_in(Phase::paused), ElementsAre("resume"));
  for (const Phase over : {Phase::completed, Phase::withdrawn, Phase::excluded, Phase::refused}) {
    EXPECT_THAT(done_in(over), ElementsAre("leave"));
  }
}

}  // namespace
}  // namespace foveola::study
