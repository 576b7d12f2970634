#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/models/additive_fit.h"
#include "renderer/base/numbers/random.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::vector<TrialValue> trials_of(const GoldenMatrix& matrix) {
  std::vector<TrialValue> values;
  for (std::size_t participant = 0; participant < matrix.size(); ++participant) {
    for (std::size_t condition = 0; condition < matrix[participant].size(); ++condition) {
      if (matrix[participant][condition]) {
        values.push_back({participant, condition, *matrix[participant][condition]});
      }
    }
  }
  return values;
}

TEST(ResidualOutliers, AreThoseOfRsLinearModels) {
  const std::map<std::string, double> golden = golden_outliers();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices("outliers_samples.csv")) {
    SCOPED_TRACE(name);
    const std::vector<ResidualOutlier> found = residual_outliers(trials_of(matrix));
    ASSERT_EQ(static_cast<double>(found.size()), golden.at(name + ".count"));
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::string number = "_" + std::to_string(i + 1);
      EXPECT_EQ(static_cast<double>(found[i].index + 1), golden.at(name + ".trial" + number));
      EXPECT_NEAR(found[i].deviation, golden.at(name + ".deviation" + number), 1e-11);
      // The leverages are R's own while no cell is missing.
      const bool complete = i == 0 && name != "missing_cells";
      const double studentized = golden.at(name + ".studentized" + number);
      EXPECT_NEAR(found[i].studentized, studentized,
                  std::abs(studentized) * (complete ? 1e-12 : 1e-3));
    }
    ++compared;
  }
  EXPECT_EQ(compared, 6);
}

/// 16 participants under 15 conditions with normal residuals of standard deviation 0.3.
std::vector<TrialValue> clean_study(std::uint64_t number) {
  Pcg32 generator(30, number);
  std::vector<double> conditions(15);
  for (double& effect : conditions) {
    effect = 0.5 * generator.normal();
  }
  std::vector<TrialValue> values;
  for (std::size_t participant = 0; participant < 16; ++participant) {
    const double person = 0.4 * generator.normal();
    for (std::size_t condition = 0; condition < conditions.size(); ++condition) {
      values.push_back(
          {participant, condition, person + conditions[condition] + 0.3 * generator.normal()});
    }
  }
  return values;
}

TEST(ResidualOutliers, FiveCleanStudiesInAHundredHaveAny) {
  constexpr std::size_t studies = 1000;
  std::size_t with_any = 0;
  for (std::size_t study = 0; study < studies; ++study) {
    with_any += residual_outliers(clean_study(study)).empty() ? 0 : 1;
  }
  const Interval share = clopper_pearson(with_any, studies, 0.999);
  EXPECT_LE(share.low, 0.05) << with_any;
  EXPECT_GE(share.high, 0.04) << with_any;
}

TEST(ResidualOutliers, ATrialFiveTimesAsLongIsFound) {
  constexpr std::size_t studies = 500;
  std::size_t found = 0;
  for (std::size_t study = 0; study < studies; ++study) {
    std::vector<TrialValue> values = clean_study(study);
    values[100].value += std::log(5.0);
    const std::vector<ResidualOutlier> outliers = residual_outliers(values);
    found += std::any_of(outliers.begin(), outliers.end(),
                         [](const ResidualOutlier& outlier) { return outlier.index == 100; })
                 ? 1
                 : 0;
  }
  // Log 5 is 5.4 standard deviations, and the limit 3.8: what chance has made quicker is missed.
  EXPECT_GE(found, studies * 85 / 100);
}

TEST(ResidualOutliers, AFewOutliersOfOneParticipantDoNotMaskEachOther) {
  std::vector<TrialValue> values = clean_study(1);
  for (const std::size_t trial : {30U, 33U, 37U, 41U}) {
    values[trial].value += std::log(20.0);
  }
  std::vector<std::size_t> found;
  for (const ResidualOutlier& outlier : residual_outliers(values)) {
    found.push_back(outlier.index);
    EXPECT_NEAR(outlier.deviation, std::log(20.0), 1.2);
  }
  EXPECT_THAT(found, UnorderedElementsAre(30, 33, 37, 41));
}

TEST(ResidualOutliers, ValuesThatTheModelFitsExactlyHaveNone) {
  std::vector<TrialValue> values;
  for (std::size_t participant = 0; participant < 8; ++participant) {
    for (std::size_t condition = 0; condition < 6; ++condition) {
      values.push_back(
          {participant, condition,
           0.1 * static_cast<double>(participant) + std::sqrt(static_cast<double>(condition))});
    }
  }
  EXPECT_THAT(residual_outliers(values), IsEmpty());
  EXPECT_THAT(residual_outliers({}), IsEmpty());
  EXPECT_THAT(residual_outliers({{0, 0, 1.0}, {0, 1, 9.0}}), IsEmpty());
}

TEST(ResidualOutliers, WhatOnlyOneTrialSaysOfAParticipantIsNoOutlier) {
  std::vector<TrialValue> values = clean_study(2);
  values.push_back({16, 0, 50.0});
  EXPECT_THAT(residual_outliers(values), IsEmpty());
}

}  // namespace
}  // namespace foveola::analysis
