#include "study/participant/make_observer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "study/participant/answers.h"
#include "study/participant/chance.h"
#include "study/participant/injected_effects/drawn_trial.h"
#include "study/participant/injected_effects/injected_effect_participant.h"
#include "study/participant/population_file.h"

namespace foveola::study {
namespace {

using std::chrono::milliseconds;

const Plan plan{{.scene = "arcade", .method = "od"},
                {.scene = "arcade", .method = "fv"},
                {.scene = "arcade", .method = "fv", .kind = TrialKind::catch_trial},
                {.scene = "church", .method = "fv"}};

KnownScene knows_nothing(const std::string& /*scene*/) { return {}; }

std::unique_ptr<Participant> injected(const std::string& effect, std::uint64_t seed = 4,
                                      int row = 0) {
  return make_observer(read_people("adults").population, parse_injected_effect(effect),
                       knows_nothing,
                       {.seed = seed, .row = row, .plan = plan, .marks = {"outline", "material"}});
}

/// The marks of a trial, in seconds after its first look, with looks every 100 ms.
std::vector<double> marks_s(Participant& observer, const Attempt& attempt) {
  constexpr Nanoseconds first = milliseconds(1014);
  observer.begin_attempt(attempt);
  observer.turn_to("arcade", {.name = "Ball"}, Nanoseconds(0));
  std::vector<double> marks;
  Nanoseconds now = first;
  for (const Task task : {Task::mark_outline, Task::mark_material}) {
    observer.begin(task, now);
    for (int look = 0; look < 20; ++look) {
      if (const auto press = observer.consider({}, now)) {
        EXPECT_GE(*press, now);
        marks.push_back(seconds(*press - first));
        now = *press;
        break;
      }
      now += milliseconds(100);
    }
  }
  return marks;
}

TEST(MakeObserver, WithoutAnEffectItLooks) {
  const auto observer = make_observer(read_people("adults").population, std::nullopt, knows_nothing,
                                      {.seed = 4, .plan = plan});
  EXPECT_EQ(dynamic_cast<InjectedEffectParticipant*>(observer.get()), nullptr);
  EXPECT_NE(dynamic_cast<InjectedEffectParticipant*>(injected("none").get()), nullptr);
}

TEST(InjectedEffectParticipant, PressesAtTheTimesThatAreDrawn) {
  const auto observer = injected("faster:fv:3,faster-mark:material:fv:1.2,outlier:2:1.5", 4, 1);
  const DrawnTrial trial{.seed = 4,
                         .participant = 2,
                         .scene = "church",
                         .method = "fv",
                         .trials_before = 3,
                         .timing = 77};
  const InjectedEffect effect =
      parse_injected_effect("faster:fv:3,faster-mark:material:fv:1.2,outlier:2:1.5");
  const std::vector<double> marks = marks_s(*observer, {.conduct = 77, .trials_before = 3});
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_NEAR(marks[0], drawn_time_s({}, effect, trial, {0, "outline"}), 1e-6);
  EXPECT_NEAR(marks[1], drawn_time_s({}, effect, trial, {1, "material"}), 1e-6);
  EXPECT_FALSE(observer->wants_retime());
}

TEST(InjectedEffectParticipant, MarksNothingInACatchTrial) {
  EXPECT_TRUE(marks_s(*injected("none"), {.conduct = 1, .trials_before = 2}).empty());
}

const std::vector<Question> asked{{.id = "comfort", .maximum = 7.0},
                                  {.id = "noise", .minimum = 0.0, .maximum = 100.0},
                                  {.id = "remark", .kind = QuestionKind::text}};

TEST(InjectedEffectParticipant, DrawsTheShiftedRatingByItsModelAndNoOtherOne) {
  const auto with = injected("shift-rating:noise:fv:20", 4, 1);
  const auto without = injected("order:1", 4, 1);
  for (std::uint32_t conduct = 0; conduct < 20; ++conduct) {
    with->begin_attempt({.conduct = conduct, .trials_before = 3});
    without->begin_attempt({.conduct = conduct, .trials_before = 3});
    const std::vector<Answer> shifted = with->rate(asked);
    const std::vector<Answer> others = without->rate(asked);
    ASSERT_EQ(shifted.size(), 3U);
    EXPECT_EQ(shifted[0], others[0]);
    EXPECT_EQ(std::get<double>(shifted[1].value),
              drawn_rating(parse_injected_effect("shift-rating:noise:fv:20"), asked[1],
                           {.seed = 4,
                            .participant = 2,
                            .scene = "church",
                            .method = "fv",
                            .trials_before = 3,
                            .timing = conduct}));
    EXPECT_EQ(shifted[2], others[2]);
  }
}

/// Studies that were simulated before asked could be shifted have to come out the same.
TEST(InjectedEffectParticipant, DrawsRatingsWithoutAnEffectLikeAFormsAnswers) {
  const auto observer = injected("faster:fv:2", 4);
  observer->begin_attempt({.conduct = 9, .trials_before = 1});
  Pcg32 random = chance(4, Chance::ratings, {9});
  EXPECT_EQ(observer->rate(asked),
            draw_answers(asked, read_people("adults").population.background, random));
}

TEST(InjectedEffectParticipant, DoesNotLook) {
  const auto observer = injected("none");
  const std::vector<double> marks = marks_s(*observer, {.conduct = 5});
  observer->begin_attempt({.conduct = 5});
  observer->begin(Task::mark_outline, milliseconds(1014));
  const auto press =
      observer->consider({.outline_signal_to_noise = 1e9, .material_jnd = 0.0}, milliseconds(1014));
  ASSERT_TRUE(press);
  EXPECT_EQ(seconds(*press - Nanoseconds(milliseconds(1014))), marks.at(0));
}

TEST(InjectedEffectParticipant, WithdrawsAsOftenAsInjectedAndStaysAway) {
  constexpr int sessions = 2000;
  int withdrawn = 0;
  for (std::uint64_t seed = 0; seed < sessions; ++seed) {
    const auto observer = injected("dropout:0.25", seed);
    EXPECT_FALSE(observer->wants_to_withdraw(0)) << "nobody leaves before the first trial";
    bool gone = false;
    for (int trial = 1; trial < 4; ++trial) {
      EXPECT_TRUE(observer->wants_to_withdraw(trial) || !gone);
      gone = observer->wants_to_withdraw(trial);
    }
    withdrawn += gone ? 1 : 0;
  }
  EXPECT_NEAR(withdrawn, 0.25 * sessions, 4.0 * std::sqrt(sessions * 0.25 * 0.75));
  EXPECT_FALSE(injected("none")->wants_to_withdraw(3));
}

}  // namespace
}  // namespace foveola::study
