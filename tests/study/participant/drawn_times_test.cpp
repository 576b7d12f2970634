#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "study/participant/injected_effects/drawn_trial.h"
#include "tests/study/participant/moments.h"

namespace foveola::study {
namespace {

constexpr int people = 20'000;

const DrawnMark first{.index = 0, .id = "outline"};
const DrawnMark second{.index = 1, .id = "material"};

/// Of ln of the ratio of two trials' first marks over many people.
Moments log_ratio(const InjectedEffect& effect, const DrawnTrial& a, const DrawnTrial& b) {
  return moments(people, [&](std::uint32_t person) {
    const auto log_time = [&](DrawnTrial trial) {
      trial.seed = person;
      return std::log(drawn_time_s({}, effect, trial, first));
    };
    return log_time(a) - log_time(b);
  });
}

const DrawnTrial fv{.scene = "arcade", .method = "fv"};
const DrawnTrial od{.scene = "arcade", .method = "od"};
const double deviation = std::sqrt(2.0) * TimesModel{}.trial_spread;
const double tolerance = 4.0 * deviation / std::sqrt(people);

TEST(DrawnTimes, AMethodIsAsMuchFasterAsInjected) {
  const Moments without = log_ratio({}, fv, od);
  EXPECT_NEAR(without.mean, 0.0, tolerance);
  EXPECT_NEAR(without.deviation, deviation, 0.02 * deviation);
  const Moments twice = log_ratio(parse_injected_effect("faster:fv:2"), fv, od);
  EXPECT_NEAR(twice.mean, -std::log(2.0), tolerance);
  EXPECT_NEAR(twice.deviation, deviation, 0.02 * deviation);
}

TEST(DrawnTimes, OneMarkIsAsMuchFasterAsInjectedBesideTheMethod) {
  const InjectedEffect effect = parse_injected_effect("faster:fv:2,faster-mark:material:fv:1.5");
  const InjectedEffect of_the_method = parse_injected_effect("faster:fv:2");
  for (const DrawnTrial& trial : {fv, od}) {
    EXPECT_EQ(drawn_time_s({}, effect, trial, first),
              drawn_time_s({}, of_the_method, trial, first));
  }
  EXPECT_NEAR(drawn_time_s({}, effect, fv, second),
              drawn_time_s({}, of_the_method, fv, second) / 1.5, 1e-9);
  EXPECT_EQ(drawn_time_s({}, effect, od, second), drawn_time_s({}, of_the_method, od, second));
}

TEST(DrawnTimes, PracticeMakesFaster) {
  DrawnTrial later = od;
  later.scene = "church";
  later.trials_before = 7;
  DrawnTrial sooner = later;
  sooner.method = "vp";
  sooner.trials_before = 2;
  EXPECT_NEAR(log_ratio(parse_injected_effect("order:0.9"), later, sooner).mean,
              5.0 * std::log(0.9), tolerance);
}

TEST(DrawnTimes, OnlyTheOutlierIsSlow) {
  const InjectedEffect effect = parse_injected_effect("outlier:3:5");
  const DrawnTrial usual{.seed = 9, .participant = 2, .scene = "arcade", .method = "od"};
  DrawnTrial slow = usual;
  slow.participant = 3;
  EXPECT_EQ(drawn_time_s({}, effect, usual, first), drawn_time_s({}, {}, usual, first));
  EXPECT_NEAR(drawn_time_s({}, effect, slow, second), 5.0 * drawn_time_s({}, {}, slow, second),
              1e-9);
}

TEST(DrawnTimes, MarksFollowOneAnotherInAFixedRatio) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const DrawnTrial trial{.seed = seed, .scene = "arcade", .method = "od"};
    EXPECT_NEAR(drawn_time_s({}, {}, trial, second) / drawn_time_s({}, {}, trial, first), 4.0,
                1e-12);
  }
}

// The logarithms of the times of one scene are normal around the scene's effect, with the sum of
// the other effects' variances.
TEST(DrawnTimes, PeopleDifferAsTheModelSays) {
  const TimesModel model;
  const Moments of_people = moments(people, [&](std::uint32_t person) {
    DrawnTrial trial = od;
    trial.seed = person;
    return std::log(drawn_time_s(model, {}, trial, first));
  });
  const double expected = std::hypot(model.participant_spread, model.trial_spread);
  EXPECT_NEAR(of_people.deviation, expected, 0.02 * expected);
}

TEST(DrawnTimes, AnotherTimingIsDrawnAnew) {
  DrawnTrial again = od;
  again.timing = 1;
  EXPECT_NE(drawn_time_s({}, {}, od, first), drawn_time_s({}, {}, again, first));
  EXPECT_EQ(drawn_time_s({}, {}, od, first), drawn_time_s({}, {}, od, first));
}

}  // namespace
}  // namespace foveola::study
