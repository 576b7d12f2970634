// The identity of a simulated participant: the same seed is the same person.
#include "study/participant/simulated_participant.h"

#include "tests/study/participant/made_up_renderings.h"
#include "tests/study/participant/moments.h"

namespace foveola::study {
namespace {

TEST_F(SimulatedParticipantTest, IsAlwaysTheSamePersonForASeedAndAnotherForAnother) {
  const Marks first = marks(participant(1), rendering);
  EXPECT_EQ(first, marks(participant(1), rendering));
  const Marks second = marks(participant(2), rendering);
  EXPECT_NE(first.outline_s, second.outline_s);
  EXPECT_NE(first.material_s, second.material_s);
}

TEST_F(SimulatedParticipantTest, StaysWithOneObjectPerSceneAndDiffersInItsChoice) {
  std::vector<int> chosen(offered.size());
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SimulatedParticipant person = participant(seed);
    const std::size_t first = person.choose_object("scene", offered);
    person.choose_object("another scene", offered);
    EXPECT_EQ(person.choose_object("scene", offered), first);
    ++chosen.at(first);
  }
  EXPECT_GT(chosen[0], 0);
  EXPECT_GT(chosen[1], 0);
}

TEST_F(SimulatedParticipantTest, AnAttemptDependsOnNothingThatWasBefore) {
  SimulatedParticipant tired = participant(1);
  sit_down(tired, 1, 99);
  Nanoseconds now = nanoseconds_from_seconds(first_presented_s);
  wait(tired, Task::mark_outline, now, rendering, 40.0);
  wait(tired, Task::look_around, now, rendering, 5.0);
  tired.rate({{.id = "artifacts", .simulated = "artifacts"}});
  tired.answer("background", {{.id = "age"}});
  tired.react(3);
  EXPECT_EQ(marks(tired, rendering), marks(participant(1), rendering));
  EXPECT_NE(marks(participant(1), rendering, 7), marks(participant(1), rendering, 8))
      << "but on its own chance";
}

TEST_F(SimulatedParticipantTest, AnswersAFormAlwaysTheSameAndAnotherDifferently) {
  const std::vector<Question> questions(
      20, {.id = "q", .kind = QuestionKind::number, .minimum = 0.0, .maximum = 1000.0});
  SimulatedParticipant person = participant(2);
  const std::vector<Answer> first = person.answer("background", questions);
  EXPECT_NE(person.answer("debrief", questions), first);
  EXPECT_EQ(person.answer("background", questions), first);
  EXPECT_NE(participant(3).answer("background", questions), first);
}

// The mean and the variance of an ex-Gaussian, times this person's own factor.
TEST_F(SimulatedParticipantTest, ReactsLikePeople) {
  population_.decision.reaction_spread = 0.0;
  population_.decision.reaction_mean_s = 0.25;
  population_.decision.reaction_deviation_s = 0.03;
  population_.decision.reaction_tail_s = 0.07;
  SimulatedParticipant person = participant(5);
  constexpr int presses = 4000;
  const Moments of_reactions =
      moments(presses, [&](std::uint32_t press) { return foveola::seconds(person.react(press)); });
  EXPECT_NEAR(of_reactions.mean, 0.320, 4.0 * 0.0762 / std::sqrt(presses));
  EXPECT_NEAR(of_reactions.deviation, std::hypot(0.030, 0.070), 0.006);
  EXPECT_EQ(person.react(17), person.react(17));
}

}  // namespace
}  // namespace foveola::study
