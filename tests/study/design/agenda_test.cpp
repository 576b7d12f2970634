// The steps of a session.

#include "study/design/plan.h"
#include "tests/matchers.h"
#include "tests/study/design/small_protocol.h"

namespace foveola::study {
namespace {

Plan trials(std::initializer_list<PlannedTrial> list) { return list; }

/// "trial" for each, with an exclamation mark if an object is chosen for it.
std::string choices_of(const Agenda& agenda) {
  std::string text;
  for (const AgendaStep& step : agenda) {
    const auto* const trial = std::get_if<TrialStep>(&step);
    text += trial == nullptr ? '-' : trial->chooses_object ? '!' : '.';
  }
  return text;
}

TEST(Agenda, FollowsThePhases) {
  Protocol protocol = test::small_protocol(1, 2, Order::fixed, Order::fixed);
  using Kind = PhaseEntry::Kind;
  protocol.phases = {{Kind::consent},    {Kind::questionnaire, "background"},
                     {Kind::validation}, {Kind::reaction},
                     {Kind::trials},     {Kind::questionnaire, "debrief"}};
  protocol.tracker.validation = ValidationSettings{.attempts = 4};
  protocol.reaction = ReactionSettings{.presses = 7};
  const Agenda agenda = agenda_of(protocol, make_plan(protocol, 1, 0));
  ASSERT_EQ(agenda.size(), 7U);
  EXPECT_TRUE(std::holds_alternative<ConsentStep>(agenda[0]));
  EXPECT_EQ(std::get<QuestionnaireStep>(agenda[1]).questionnaire, "background");
  EXPECT_EQ(std::get<ValidationStep>(agenda[2]).attempts, 4);
  EXPECT_EQ(std::get<ReactionStep>(agenda[3]).presses, 7);
  EXPECT_EQ(std::get<TrialStep>(agenda[4]).trial, 0U);
  EXPECT_EQ(std::get<TrialStep>(agenda[5]).trial, 1U);
  EXPECT_EQ(std::get<QuestionnaireStep>(agenda[6]).questionnaire, "debrief");
}

TEST(Agenda, AnObjectIsChosenOnceASceneOrForEachTrial) {
  Protocol protocol = test::small_protocol(2, 3, Order::fixed, Order::fixed);
  const Plan plan = make_plan(protocol, 1, 0);
  EXPECT_EQ(choices_of(agenda_of(protocol, plan)), "!..!..");
  protocol.object_choice = ObjectChoice::per_method;
  EXPECT_EQ(choices_of(agenda_of(protocol, plan)), "!!!!!!");
}

TEST(Agenda, ACatchTrialHasTheStepsOfATest) {
  const Protocol protocol = test::small_protocol(2, 2, Order::fixed, Order::fixed);
  const auto test = [](const char* scene) { return PlannedTrial{.scene = scene, .method = "x"}; };
  const auto practice = [](const char* scene) {
    return PlannedTrial{.scene = scene, .method = "x", .kind = TrialKind::practice};
  };
  const PlannedTrial catch_trial{.scene = "a", .method = "x", .kind = TrialKind::catch_trial};
  EXPECT_EQ(choices_of(agenda_of(
                protocol, trials({practice("b"), practice("b"), practice("a"), test("a"),
                                  catch_trial, test("a"), catch_trial, test("b"), test("b")}))),
            "!.!!...!.");
}

}  // namespace
}  // namespace foveola::study
