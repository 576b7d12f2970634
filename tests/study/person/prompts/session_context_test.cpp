#include "study/person/prompts/session_context.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

PlannedTrial trial(const std::string& scene, TrialKind kind = TrialKind::test) {
  return {.scene = scene, .method = "od", .kind = kind};
}

/// Two trials of practice, then two scenes, one of them with a catch trial.
const Plan whole_plan = {trial("hall", TrialKind::practice), trial("hall", TrialKind::practice),
                         trial("hall"), trial("hall", TrialKind::catch_trial), trial("yard")};

class SessionContextTest : public ::testing::Test {
 protected:
  /// In the first attempt at a trial of a plan, or in another one.
  static std::optional<Notice> notice_before(std::size_t index, const Plan& plan, int attempt = 1) {
    const Procedure procedure{.agenda = {TrialStep{.trial = index}}};
    const SessionState state{.phase = Phase::ready, .attempt = attempt};
    const Protocol protocol;
    return notice_before_trial({protocol, plan, procedure, state});
  }
};

TEST_F(SessionContextTest, PracticeItsEndAndNewScenesHaveNotices) {
  EXPECT_EQ(notice_before(0, whole_plan), Notice::practice);
  EXPECT_EQ(notice_before(1, whole_plan), std::nullopt);
  EXPECT_EQ(notice_before(2, whole_plan), Notice::first_trial);
  EXPECT_EQ(notice_before(3, whole_plan), std::nullopt) << "nobody must know of a catch trial";
  EXPECT_EQ(notice_before(4, whole_plan), Notice::next_scene);
}

TEST_F(SessionContextTest, WithoutPracticeTheFirstTrialIsNoNews) {
  EXPECT_EQ(notice_before(0, {trial("hall"), trial("yard")}), std::nullopt);
}

TEST_F(SessionContextTest, AnotherAttemptIsNoNews) {
  for (std::size_t index = 0; index < whole_plan.size(); ++index) {
    EXPECT_EQ(notice_before(index, whole_plan, 2), std::nullopt);
  }
}

TEST_F(SessionContextTest, PracticeIsCountedByItselfAndCatchTrialsAsOthers) {
  const auto expect = [](std::size_t index, std::size_t trial, std::size_t trials) {
    const TrialCount count = trial_count(whole_plan, index);
    EXPECT_EQ(count.trial, trial) << index;
    EXPECT_EQ(count.trials, trials) << index;
  };
  expect(0, 1, 2);
  expect(1, 2, 2);
  expect(2, 1, 3);
  expect(3, 2, 3);
  expect(4, 3, 3);
}

TEST_F(SessionContextTest, ThereIsATrialOnlyInATrialsPhase) {
  const Protocol protocol;
  const Procedure procedure{.agenda = {ConsentStep{}, TrialStep{.trial = 4}}};
  const SessionState consent{.phase = Phase::consent};
  EXPECT_THROW(trial_at({protocol, whole_plan, procedure, consent}), std::logic_error);
  const SessionState ready{.phase = Phase::ready, .step = 1};
  EXPECT_EQ(trial_at({protocol, whole_plan, procedure, ready}).scene, "yard");
}

}  // namespace
}  // namespace foveola::study
