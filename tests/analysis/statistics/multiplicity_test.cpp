#include "analysis/statistics/multiplicity.h"

#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(Multiplicity, HolmsPValuesAreThoseOfR) {
  const auto golden = golden_inference();
  const std::vector<double> adjusted = holm(golden_column(golden_matrices().at("p_values"), 0));
  ASSERT_EQ(adjusted.size(), 8U);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    EXPECT_GOLDEN(adjusted[i], golden.at("p_values.holm_" + std::to_string(i + 1)));
  }
}

TEST(Multiplicity, OneTestStaysAsItIs) {
  EXPECT_THAT(holm(std::vector<double>{0.03}), ElementsAre(0.03));
  EXPECT_TRUE(holm(std::vector<double>{}).empty());
}

}  // namespace
}  // namespace foveola::analysis
