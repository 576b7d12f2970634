#include "analysis/statistics/repeated_measures.h"

#include <algorithm>

#include "analysis/statistics/paired_t.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/pairs.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(RepeatedMeasures, AnalysesOfVarianceAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".f")) {
      continue;
    }
    SCOPED_TRACE(name);
    const VarianceAnalysis test = repeated_measures_anova(complete_participants(matrix)).value();
    EXPECT_GOLDEN(test.f, golden.at(name + ".f"));
    EXPECT_GOLDEN(test.p, golden.at(name + ".f_p"));
    EXPECT_GOLDEN(test.greenhouse_geisser, golden.at(name + ".epsilon"));
    EXPECT_GOLDEN(test.p_greenhouse_geisser, golden.at(name + ".f_p_gg"));
    EXPECT_GOLDEN(test.huynh_feldt, golden.at(name + ".huynh_feldt"));
    EXPECT_GOLDEN(test.p_huynh_feldt, golden.at(name + ".f_p_hf"));
    EXPECT_GOLDEN(test.partial_eta_squared, golden.at(name + ".partial_eta_squared"));
    ++compared;
  }
  EXPECT_EQ(compared, 9);
}

TEST(RepeatedMeasures, ParticipantsWithAGapAreLeftOut) {
  const GoldenMatrix matrix = golden_matrices().at("gaps");
  EXPECT_EQ(matrix.size(), 16U);
  const RepeatedMeasures data = complete_participants(matrix);
  EXPECT_EQ(data.participants, 14U);
  EXPECT_EQ(data.conditions, 4U);
  EXPECT_EQ(data.at(1, 2), matrix[2][2].value());
}

TEST(RepeatedMeasures, TwoConditionsAreAPairedT) {
  const GoldenMatrix matrix = golden_matrices().at("two_conditions");
  const VarianceAnalysis f = repeated_measures_anova(complete_participants(matrix)).value();
  const TTest t =
      test_mean(differences(golden_column(matrix, 0), golden_column(matrix, 1))).value();
  EXPECT_GOLDEN(f.f, t.t * t.t);
  EXPECT_GOLDEN(f.p, t.p);
  EXPECT_EQ(f.greenhouse_geisser, 1.0);
}

TEST(RepeatedMeasures, ACommonOffsetLeavesTheTest) {
  GoldenMatrix matrix = {{1.25, 2.5, 4.0}, {2.0, 2.25, 5.5}, {0.5, 3.0, 3.75}};
  const double f = repeated_measures_anova(complete_participants(matrix))->f;
  for (auto& row : matrix) {
    for (auto& value : row) {
      *value += 1e9;
    }
  }
  EXPECT_DOUBLE_EQ(repeated_measures_anova(complete_participants(matrix))->f, f);
}

TEST(RepeatedMeasures, WhatDoesNotVaryHasNoF) {
  EXPECT_FALSE(repeated_measures_anova(complete_participants({{2.0, 2.0}, {2.0, 2.0}})));
  // Everybody differs between the conditions by the same 0.1, up to its rounding.
  EXPECT_FALSE(
      repeated_measures_anova(complete_participants({{0.1, 0.2}, {0.2, 0.3}, {0.6, 0.7}})));
  EXPECT_FALSE(repeated_measures_anova(complete_participants({{1.0, 2.0, 4.0}})));
  EXPECT_FALSE(repeated_measures_anova(complete_participants({{1.0}, {2.0}})));
  EXPECT_FALSE(repeated_measures_anova(complete_participants({})));
}

}  // namespace
}  // namespace foveola::analysis
