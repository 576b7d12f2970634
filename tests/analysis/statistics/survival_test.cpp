#include "analysis/statistics/survival.h"

#include <cmath>

#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::vector<TimeToMark> times_of(const GoldenMatrix& matrix) {
  std::vector<TimeToMark> times;
  for (const auto& row : matrix) {
    times.push_back({row[0].value(), row[1].value() == 1.0});
  }
  return times;
}

/// R's values of one sample; what is not defined has none.
class GoldenCurve {
 public:
  explicit GoldenCurve(std::string sample) : sample_(std::move(sample)) {}

  void expect(std::optional<double> value, const std::string& quantity) const {
    SCOPED_TRACE(quantity);
    const auto golden = values_.find(sample_ + "." + quantity);
    ASSERT_EQ(value.has_value(), golden != values_.end());
    if (value) {
      EXPECT_GOLDEN(*value, golden->second);
    }
  }
  bool has(const std::string& quantity) const { return values_.contains(sample_ + "." + quantity); }

 private:
  std::string sample_;
  std::map<std::string, double> values_ = golden_survival();
};

std::optional<double> low_of(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->low) : std::nullopt;
}

std::optional<double> high_of(const std::optional<Interval>& interval) {
  return interval ? std::optional(interval->high) : std::nullopt;
}

TEST(Survival, CurvesAreThoseOfR) {
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices("survival_samples.csv")) {
    SCOPED_TRACE(name);
    const GoldenCurve golden(name);
    const SurvivalCurve curve = kaplan_meier(times_of(matrix));
    golden.expect(static_cast<double>(curve.n), "n");
    golden.expect(static_cast<double>(curve.events), "events");
    golden.expect(static_cast<double>(curve.steps.size()), "steps");
    EXPECT_EQ(curve.censored, curve.n - curve.events);
    for (std::size_t i = 0; i < curve.steps.size(); ++i) {
      const SurvivalStep& step = curve.steps[i];
      const std::string number = "_" + std::to_string(i + 1);
      golden.expect(step.time, "time" + number);
      golden.expect(static_cast<double>(step.at_risk), "at_risk" + number);
      golden.expect(static_cast<double>(step.events), "events" + number);
      golden.expect(static_cast<double>(step.censored), "censored" + number);
      golden.expect(step.survival, "survival" + number);
      golden.expect(step.standard_error, "standard_error" + number);
      golden.expect(low_of(step.interval), "low" + number);
      golden.expect(high_of(step.interval), "high" + number);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 10);
}

TEST(Survival, MediansAreThoseOfR) {
  for (const auto& [name, matrix] : golden_matrices("survival_samples.csv")) {
    SCOPED_TRACE(name);
    const GoldenCurve golden(name);
    const std::optional<SurvivalMedian> median = kaplan_meier(times_of(matrix)).median;
    golden.expect(median ? std::optional(median->value) : std::nullopt, "median");
    golden.expect(median ? median->low : std::nullopt, "median_low");
    golden.expect(median ? median->high : std::nullopt, "median_high");
  }
}

TEST(Survival, RestrictedMeansAreThoseOfR) {
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices("survival_samples.csv")) {
    const GoldenCurve golden(name);
    const SurvivalCurve curve = kaplan_meier(times_of(matrix));
    for (const int horizon : {6, 8, 20, 180}) {
      const std::string number = "_" + std::to_string(horizon);
      if (!golden.has("mean" + number)) {  // R refuses a horizon before the first time
        continue;
      }
      SCOPED_TRACE(name + number);
      const RestrictedMean mean = restricted_mean(curve, horizon).value();
      golden.expect(mean.mean, "mean" + number);
      golden.expect(mean.standard_error, "mean_error" + number);
      ++compared;
    }
  }
  EXPECT_GE(compared, 25);
}

TEST(Survival, WithoutCensoringItIsTheShareOfLongerTimes) {
  const std::vector<TimeToMark> times = {{4.0}, {1.0}, {2.0}, {2.0}, {8.0}};
  const SurvivalCurve curve = kaplan_meier(times);
  ASSERT_EQ(curve.steps.size(), 4U);
  EXPECT_DOUBLE_EQ(curve.steps[0].survival, 0.8);
  EXPECT_DOUBLE_EQ(curve.steps[1].survival, 0.4);
  EXPECT_DOUBLE_EQ(curve.steps[1].standard_error.value(), std::sqrt(0.4 * 0.6 / 5.0));
  EXPECT_DOUBLE_EQ(curve.steps[2].survival, 0.2);
  EXPECT_EQ(curve.steps[3].survival, 0.0);
  EXPECT_DOUBLE_EQ(restricted_mean(curve, 100.0)->mean, 17.0 / 5.0);
  EXPECT_DOUBLE_EQ(restricted_mean(curve, 3.0)->mean, (1.0 + 2.0 + 2.0 + 3.0 + 3.0) / 5.0);
}

TEST(Survival, BeforeTheFirstTimeTheRestrictedMeanIsTheHorizon) {
  const std::vector<TimeToMark> times = {{4.0}, {5.0}};
  const RestrictedMean mean = restricted_mean(kaplan_meier(times), 0.5).value();
  EXPECT_EQ(mean.mean, 0.5);
  EXPECT_EQ(mean.standard_error, 0.0);
}

TEST(Survival, OfNothingThereIsNoCurve) {
  const SurvivalCurve curve = kaplan_meier({});
  EXPECT_EQ(curve.n, 0U);
  EXPECT_TRUE(curve.steps.empty());
  EXPECT_FALSE(curve.median);
  EXPECT_FALSE(restricted_mean(curve, 180.0));
}

}  // namespace
}  // namespace foveola::analysis
