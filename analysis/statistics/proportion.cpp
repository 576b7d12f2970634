#include "analysis/statistics/proportion.h"

#include <cassert>

#include <boost/math/distributions/beta.hpp>

namespace foveola::analysis {

Interval clopper_pearson(std::size_t successes, std::size_t trials, double confidence) {
  assert(trials >= 1 && successes <= trials);
  const double tail = (1.0 - confidence) / 2.0;
  const auto hits = static_cast<double>(successes);
  const auto misses = static_cast<double>(trials - successes);
  Interval interval{0.0, 1.0};
  if (successes > 0) {
    interval.low =
        boost::math::quantile(boost::math::beta_distribution<>(hits, misses + 1.0), tail);
  }
  if (successes < trials) {
    interval.high = boost::math::quantile(
        boost::math::complement(boost::math::beta_distribution<>(hits + 1.0, misses), tail));
  }
  return interval;
}

}  // namespace foveola::analysis
