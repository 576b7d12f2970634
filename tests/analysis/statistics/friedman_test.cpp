#include "analysis/statistics/rank_tests.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Friedman, TestsAreThoseOfR) {
  const auto golden = golden_inference();
  int compared = 0;
  for (const auto& [name, matrix] : golden_matrices()) {
    if (!golden.contains(name + ".chi_squared")) {
      continue;
    }
    SCOPED_TRACE(name);
    const FriedmanTest test = friedman(complete_participants(matrix)).value();
    EXPECT_GOLDEN(test.chi_squared, golden.at(name + ".chi_squared"));
    EXPECT_GOLDEN(test.p, golden.at(name + ".chi_squared_p"));
    EXPECT_GOLDEN(test.kendalls_w, golden.at(name + ".kendalls_w"));
    ++compared;
  }
  EXPECT_EQ(compared, 9);
}

TEST(Friedman, WhoAllAgreeHaveAnAgreementOfOne) {
  const FriedmanTest test =
      friedman(complete_participants({{1.0, 5.0, 9.0}, {2.0, 2.5, 3.0}, {0.0, 1.0, 7.0}})).value();
  EXPECT_DOUBLE_EQ(test.kendalls_w, 1.0);
  EXPECT_DOUBLE_EQ(test.chi_squared, 6.0);
}

TEST(Friedman, PValuesAreRightDownTo1eMinus300) {
  const std::vector<std::vector<std::optional<double>>> agreeing(690, {1.0, 2.0, 3.0});
  const FriedmanTest test = friedman(complete_participants(agreeing)).value();
  EXPECT_DOUBLE_EQ(test.chi_squared, 1380.0);
  EXPECT_GOLDEN(test.p, golden_inference().at("tails.chi_squared_1380"));
}

TEST(Friedman, OneParticipantOrNoDifferenceBetweenConditionsHasNoTest) {
  EXPECT_FALSE(friedman(complete_participants({{3.0, 3.0, 3.0}, {2.0, 2.0, 2.0}})));
  EXPECT_FALSE(friedman(complete_participants({{1.0}, {2.0}})));
  EXPECT_FALSE(friedman(complete_participants({{1.0, 2.0, 3.0}})));
  EXPECT_FALSE(friedman(complete_participants({})));
}

}  // namespace
}  // namespace foveola::analysis
