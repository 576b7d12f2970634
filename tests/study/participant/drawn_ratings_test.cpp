#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "study/participant/injected_effects/drawn_trial.h"
#include "tests/study/participant/moments.h"

namespace foveola::study {
namespace {

constexpr int raters = 20'000;

const Question zero_to_hundred{.id = "it", .minimum = 0.0, .maximum = 100.0};
const Question one_to_five{.id = "it", .minimum = 1.0, .maximum = 5.0};
const Question decimals{
    .id = "it", .kind = QuestionKind::number, .minimum = -0.75, .maximum = 3.25};
const Question choice{.id = "it",
                      .kind = QuestionKind::choice,
                      .options = {{"much", 2.0}, {"none", 0.0}, {"a little", 0.5}}};

struct Drawn : Moments {
  std::set<double> answers{};
};

Drawn drawn_by_many(const Question& rating, const std::string& effect, const std::string& method) {
  const InjectedEffect injected = parse_injected_effect(effect);
  std::set<double> answers;
  const Moments of_answers = moments(raters, [&](std::uint32_t person) {
    const DrawnTrial trial{.seed = person, .scene = "arcade", .method = method};
    return *answers.insert(drawn_rating(injected, rating, trial)).first;
  });
  return {of_answers, std::move(answers)};
}

struct Case {
  const Question& rating;
  std::string effect;
  double shift = 0.0;
};

class DrawnRatings : public testing::TestWithParam<Case> {};

TEST_P(DrawnRatings, AMethodsAreHigherByWhatWasInjectedWithinTheScale) {
  const Case& test = GetParam();
  const Drawn fv = drawn_by_many(test.rating, test.effect, "fv");
  const Drawn od = drawn_by_many(test.rating, test.effect, "od");
  EXPECT_NEAR(fv.mean - od.mean, test.shift,
              4.0 * std::hypot(fv.deviation, od.deviation) / std::sqrt(raters));
  const Span span = span_of(test.rating);
  for (const Drawn& drawn : {fv, od}) {
    EXPECT_GE(*drawn.answers.begin(), span.low);
    EXPECT_LE(*drawn.answers.rbegin(), span.high);
    EXPECT_GT(drawn.deviation, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scales, DrawnRatings,
    testing::Values(Case{zero_to_hundred, "shift-rating:it:fv:10", 10.0},
                    Case{zero_to_hundred, "shift-rating:it:fv:-30,shift-rating:it:vp:30", -30.0},
                    Case{zero_to_hundred, "shift-rating:it:vp:10", 0.0},
                    Case{zero_to_hundred, "shift-rating:it:fv:0", 0.0},
                    Case{one_to_five, "shift-rating:it:fv:1", 1.0},
                    Case{one_to_five, "shift-rating:it:fv:0.3", 0.3},
                    Case{one_to_five, "shift-rating:it:fv:-3.5", -3.5},
                    Case{decimals, "shift-rating:it:fv:0.6", 0.6},
                    Case{choice, "shift-rating:it:fv:-0.5,shift-rating:it:od:0.25", -0.75}));

TEST(DrawnRatings, AreAnswersThatTheScaleHas) {
  for (const double answer : drawn_by_many(one_to_five, "shift-rating:it:fv:0.3", "fv").answers) {
    EXPECT_EQ(answer, std::round(answer));
  }
  EXPECT_EQ(drawn_by_many(choice, "shift-rating:it:fv:0.1", "fv").answers,
            (std::set{0.0, 0.5, 2.0}));
}

/// The model's standard deviation on a wide scale: two triangular effects, each of at most a
/// quarter of what the shift leaves of it (their variance is a sixth of the square of that), and
/// rounding.
TEST(DrawnRatings, VaryAsTheModelSays) {
  const double quarter = 90.0 / 4.0;
  const double expected = std::sqrt(2.0 * quarter * quarter / 6.0 + 1.0 / 6.0);
  EXPECT_NEAR(drawn_by_many(zero_to_hundred, "shift-rating:it:fv:10", "fv").deviation, expected,
              0.03 * expected);
}

TEST(DrawnRatings, AnotherTimingOrRatingIsDrawnAnew) {
  const InjectedEffect effect =
      parse_injected_effect("shift-rating:it:fv:1,shift-rating:other:fv:1");
  Question other = zero_to_hundred;
  other.id = "other";
  const DrawnTrial trial{.seed = 3, .scene = "arcade", .method = "fv"};
  DrawnTrial again = trial;
  again.timing = 1;
  const double answer = drawn_rating(effect, zero_to_hundred, trial);
  EXPECT_EQ(answer, drawn_rating(effect, zero_to_hundred, trial));
  EXPECT_NE(answer, drawn_rating(effect, zero_to_hundred, again));
  EXPECT_NE(answer, drawn_rating(effect, other, trial));
}

}  // namespace
}  // namespace foveola::study
