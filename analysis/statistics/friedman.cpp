#include "analysis/statistics/friedman.h"

#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "analysis/statistics/ranks.h"

namespace foveola::analysis {

std::optional<FriedmanTest> friedman(const RepeatedMeasures& data) {
  if (data.participants < 2 || data.conditions < 2) {
    return std::nullopt;
  }
  const auto n = static_cast<double>(data.participants);
  const auto k = static_cast<double>(data.conditions);
  std::vector<double> rank_sums(data.conditions, 0.0);
  double ties = 0.0;
  for (std::size_t participant = 0; participant < data.participants; ++participant) {
    const Ranks ranks = rank(data.of(participant));
    ties += ranks.tie_correction;
    for (std::size_t condition = 0; condition < data.conditions; ++condition) {
      rank_sums[condition] += ranks.ranks[condition];
    }
  }
  const double scale = n * k * (k + 1.0) - ties / (k - 1.0);
  if (scale <= 0.0) {
    return std::nullopt;
  }
  double squares = 0.0;
  for (const double sum : rank_sums) {
    const double deviation = sum - n * (k + 1.0) / 2.0;
    squares += deviation * deviation;
  }
  FriedmanTest test;
  test.participants = data.participants;
  test.conditions = data.conditions;
  test.chi_squared = 12.0 * squares / scale;
  test.degrees_of_freedom = k - 1.0;
  const boost::math::chi_squared distribution(test.degrees_of_freedom);
  test.p = boost::math::cdf(boost::math::complement(distribution, test.chi_squared));
  test.kendalls_w = test.chi_squared / (n * (k - 1.0));
  return test;
}

}  // namespace foveola::analysis
