#include "study/participant/observer/decision.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/study/participant/moments.h"

namespace foveola::study {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds glance_interval(100);

/// A population whose people do not vary at random.
constexpr DecisionHabits plain{.outline_signal_to_noise = 5.0,
                               .material_jnd = 1.5,
                               .integration_s = 0.2,
                               .evidence_limit = 2.0,
                               .early_factor = 3.0};

/// The evidence after a number of glances.
using Show = std::function<Evidence(int glance)>;

Evidence outline(double signal_to_noise) { return {.outline_signal_to_noise = signal_to_noise}; }
Evidence material(double jnd) { return {.material_jnd = jnd}; }

Show always(const Evidence& evidence) {
  return [evidence](int) { return evidence; };
}

struct Press {
  int glance = 0;  ///< The last glance before the press, from 0 on.
  double delay_s = 0.0;
};

std::optional<Press> press(Decision& decision, Task task, const Show& show, int glances = 200) {
  decision.begin(task, Nanoseconds(0));
  for (int glance = 0; glance < glances; ++glance) {
    const Nanoseconds now = glance * glance_interval;
    if (const auto pressed = decision.consider(show(glance), now)) {
      return Press{.glance = glance, .delay_s = seconds(*pressed - now)};
    }
  }
  return std::nullopt;
}

std::optional<Press> press(const DecisionHabits& habits, Task task, const Show& show,
                           const Attempt& attempt = {}, const Traits& traits = {}) {
  Decision decision(habits, traits, 1);
  decision.begin_attempt(attempt);
  return press(decision, task, show);
}

TEST(Decision, IsMadeAboveTheCriterionOnly) {
  EXPECT_TRUE(press(plain, Task::mark_outline, always(outline(5.01))));
  EXPECT_FALSE(press(plain, Task::mark_outline, always(outline(4.99))));
  EXPECT_TRUE(press(plain, Task::mark_material, always(material(1.49))));
  EXPECT_FALSE(press(plain, Task::mark_material, always(material(1.51))));
  EXPECT_FALSE(press(plain, Task::mark_outline, always(outline(0.0)))) << "of nothing at all";
  EXPECT_TRUE(press(plain, Task::mark_material, always(material(0.0)))) << "of no difference";
}

TEST(Decision, IsNotMadeBeforeAnIntegrationTimeHasPassed) {
  EXPECT_EQ(press(plain, Task::mark_outline, always(outline(100.0)))->glance, 2);
}

// With weights of 1 - exp(-0.1 / 0.2) = 0.39347, evidence that jumps from -2 to 2 (its limits) has
// a leaky mean of 2 - 4 x 0.60653^n after n glances, which is above 0 from n = 2 on.
TEST(Decision, FollowsEvidenceWithALeakyMean) {
  const auto jump = [](int glance) { return outline(glance < 10 ? 1e-9 : 1e9); };
  EXPECT_EQ(press(plain, Task::mark_outline, jump)->glance, 11);
  const auto flash = [](int glance) { return outline(glance == 10 ? 1e9 : 1e-9); };
  EXPECT_FALSE(press(plain, Task::mark_outline, flash));
}

TEST(Decision, IsMadeByThePersonsOwnCriteriaWhichDriftFromTrialToTrial) {
  const Traits strict{.outline_criterion = 2.0, .material_criterion = 0.5};
  EXPECT_FALSE(press(plain, Task::mark_outline, always(outline(9.9)), {}, strict));
  EXPECT_TRUE(press(plain, Task::mark_outline, always(outline(10.1)), {}, strict));
  EXPECT_FALSE(press(plain, Task::mark_material, always(material(0.76)), {}, strict));
  EXPECT_TRUE(press(plain, Task::mark_material, always(material(0.74)), {}, strict));

  const Traits tiring{.drift_per_trial = 0.1};
  const double after_ten = 5.0 * std::exp(1.0);
  const Attempt tenth{.trials_before = 10};
  EXPECT_TRUE(press(plain, Task::mark_outline, always(outline(5.1)), {}, tiring));
  EXPECT_FALSE(press(plain, Task::mark_outline, always(outline(0.99 * after_ten)), tenth, tiring));
  EXPECT_TRUE(press(plain, Task::mark_outline, always(outline(1.01 * after_ten)), tenth, tiring));
}

// After ten seconds of waiting at a tenth a second half the signal-to-noise ratio will do, or twice
// the difference.
TEST(Decision, WhoHasWaitedIsContentWithLess) {
  DecisionHabits impatient = plain;
  impatient.impatience_per_s = 0.1;
  const auto outline_pressed = press(impatient, Task::mark_outline, always(outline(2.5)));
  ASSERT_TRUE(outline_pressed);
  EXPECT_NEAR(outline_pressed->glance, 100, 4) << "later by the leaky mean";
  const auto material_pressed = press(impatient, Task::mark_material, always(material(3.0)));
  ASSERT_TRUE(material_pressed);
  EXPECT_NEAR(material_pressed->glance, 100, 4);
}

TEST(Decision, TheSecondMarksWaitBeganWithTheFirst) {
  DecisionHabits impatient = plain;
  impatient.impatience_per_s = 0.1;
  Decision decision(impatient, {}, 1);
  decision.begin_attempt({});
  decision.begin(Task::mark_outline, Nanoseconds(0));
  for (int glance = 0; !decision.consider(outline(6.0), glance * glance_interval); ++glance) {
  }
  const Nanoseconds later = std::chrono::seconds(10);
  decision.begin(Task::mark_material, later);
  EXPECT_FALSE(decision.consider(material(2.9), later)) << "no decision at the first glance";
  EXPECT_TRUE(decision.consider(material(2.9), later + 3 * glance_interval));
  decision.begin_attempt({});
  decision.begin(Task::mark_outline, later);
  EXPECT_FALSE(decision.consider(outline(4.5), later + 3 * glance_interval)) << "a new attempt";
}

TEST(Decision, IsOverAfterThePress) {
  Decision decision(plain, {}, 1);
  decision.begin_attempt({});
  ASSERT_TRUE(press(decision, Task::mark_outline, always(outline(10.0))));
  for (int glance = 10; glance < 30; ++glance) {
    EXPECT_FALSE(decision.consider(outline(10.0), glance * glance_interval));
  }
  EXPECT_FALSE(press(decision, Task::look_around, always(outline(10.0))));
}

constexpr int draws = 20'000;

/// Within four standard errors of a mean.
double mean_tolerance(double deviation) { return 4.0 * deviation / std::sqrt(draws); }

// The mean of the ex-Gaussian distribution is mu + tau, its variance sigma^2 + tau^2 (Luce 1986).
TEST(Decision, ReactionsAreExGaussian) {
  DecisionHabits habits = plain;
  habits.reaction_mean_s = 0.25;
  habits.reaction_deviation_s = 0.03;
  habits.reaction_tail_s = 0.07;
  const double deviation = std::hypot(0.03, 0.07);
  const Moments of_delays = moments(draws, [&](std::uint32_t conduct) {
    return press(habits, Task::mark_outline, always(outline(10.0)), {.conduct = conduct})->delay_s;
  });
  EXPECT_NEAR(of_delays.mean, 0.32, mean_tolerance(deviation));
  EXPECT_NEAR(of_delays.deviation, deviation, 0.004);
  const Moments of_slow_ones = moments(draws, [&](std::uint32_t conduct) {
    Pcg32 random(conduct, 5);
    return seconds(draw_reaction(habits, {.reaction = 2.0}, random));
  });
  EXPECT_NEAR(of_slow_ones.mean, 0.64, mean_tolerance(2.0 * deviation));
}

// A lapse in a quarter of the marks, of 2 s in the mean, adds half a second to the mean.
TEST(Decision, LapsesComeAsOftenAndAreAsLongAsTheyShould) {
  DecisionHabits habits = plain;
  habits.lapse_part = 0.25;
  habits.lapse_s = 2.0;
  int lapses = 0;
  const Moments of_delays = moments(draws, [&](std::uint32_t conduct) {
    const auto pressed =
        press(habits, Task::mark_outline, always(outline(10.0)), {.conduct = conduct});
    lapses += pressed->delay_s > 0.0 ? 1 : 0;
    return pressed->delay_s;
  });
  EXPECT_NEAR(lapses, 0.25 * draws, 4.0 * std::sqrt(draws * 0.25 * 0.75));
  // The variance of a mixture: 2 x 2^2 / 4 - 0.5^2.
  EXPECT_NEAR(of_delays.mean, 0.5, mean_tolerance(std::sqrt(2.0 - 0.25)));
}

TEST(Decision, EarlyPressesAreMadeOnLessEvidenceAndSomeAreNoticed) {
  DecisionHabits habits = plain;
  habits.early_part = 0.3;
  habits.early_noticed_part = 0.6;
  int early = 0;
  int regretted = 0;
  for (std::uint32_t conduct = 0; conduct < 5000; ++conduct) {
    Decision decision(habits, {}, 2);
    decision.begin_attempt({.conduct = conduct});
    // A factor of 2 short of the criterion.
    const bool pressed = press(decision, Task::mark_outline, always(outline(2.5)), 5).has_value();
    early += pressed ? 1 : 0;
    regretted += decision.wants_retime() ? 1 : 0;
    EXPECT_TRUE(pressed || !decision.wants_retime());
    decision.begin_attempt({.conduct = conduct});
    EXPECT_FALSE(decision.wants_retime()) << "another timing begins without regrets";
    EXPECT_FALSE(press(decision, Task::mark_outline, always(outline(1.6)), 5))
        << "a factor of more than 3 short";
  }
  EXPECT_NEAR(early, 1500.0, 4.0 * std::sqrt(5000 * 0.3 * 0.7));
  EXPECT_NEAR(regretted, 900.0, 4.0 * std::sqrt(5000 * 0.18 * 0.82));
}

TEST(Decision, NoiseMakesTheMomentVaryAroundTheCriterion) {
  DecisionHabits habits = plain;
  habits.glance_noise = 0.1;
  // Evidence that rises by 1 % a glance, and meets the criterion at the 70th.
  const auto rising = [](int glance) { return outline(5.0 * std::pow(1.01, glance - 70)); };
  const Moments of_glances = moments(500, [&](std::uint32_t conduct) {
    return press(habits, Task::mark_outline, rising, {.conduct = conduct})->glance;
  });
  EXPECT_LT(of_glances.mean, 70.0) << "the first of many chances is taken";
  EXPECT_GT(of_glances.mean, 50.0);
  EXPECT_GT(of_glances.deviation, 1.0);
}

TEST(Decision, WhatIsDrawnDoesNotDependOnWhatIsSeen) {
  DecisionHabits habits = plain;
  habits.glance_noise = 0.3;
  habits.reaction_mean_s = 0.25;
  habits.reaction_tail_s = 0.07;
  habits.lapse_part = 0.5;
  habits.lapse_s = 1.0;
  for (std::uint32_t conduct = 0; conduct < 50; ++conduct) {
    const Attempt attempt{.conduct = conduct};
    const auto soon = press(habits, Task::mark_outline, always(outline(1e9)), attempt);
    const auto late = press(
        habits, Task::mark_outline, [](int glance) { return outline(glance < 50 ? 1e-9 : 1e9); },
        attempt);
    EXPECT_NE(soon->glance, late->glance);
    EXPECT_EQ(soon->delay_s, late->delay_s);
  }
}

TEST(Traits, SpreadBetweenPeopleAsAskedFor) {
  Population population;
  population.decision.criterion_spread = 0.25;
  population.decision.reaction_spread = 0.1;
  population.decision.drift_per_trial = 0.02;
  population.rating.bias_spread = 0.5;
  const auto of = [&](double Traits::* trait, bool in_log) {
    return moments(draws, [&](std::uint32_t seed) {
      const double value = draw_traits(population, seed).*trait;
      return in_log ? std::log(value) : value;
    });
  };
  const auto expect = [](const Moments& drawn, double deviation) {
    EXPECT_NEAR(drawn.mean, 0.0, mean_tolerance(deviation));
    EXPECT_NEAR(drawn.deviation, deviation, 0.03 * deviation);
  };
  expect(of(&Traits::outline_criterion, true), 0.25);
  expect(of(&Traits::material_criterion, true), 0.25);
  expect(of(&Traits::reaction, true), 0.1);
  expect(of(&Traits::rating_bias, true), 0.5);
  expect(of(&Traits::drift_per_trial, false), 0.02);
}

}  // namespace
}  // namespace foveola::study
