#include "analysis/statistics/power.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include <boost/math/distributions/non_central_t.hpp>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/paired_t.h"
#include "renderer/base/numbers/random.h"

namespace foveola::analysis {

ExpectedEffect effect_of_ratio(double percent, double spread) {
  assert(percent > 0.0 && spread > 1.0);
  return {std::log(percent / 100.0), std::log(spread)};
}

double paired_t_power(std::size_t n, const ExpectedEffect& effect, double alpha) {
  assert(n >= 2 && effect.standard_deviation > 0.0);
  const auto participants = static_cast<double>(n);
  const double critical = student_t_quantile(1.0 - alpha, participants - 1.0);
  const double noncentrality =
      std::sqrt(participants) * std::abs(effect.mean) / effect.standard_deviation;
  const boost::math::non_central_t distribution(participants - 1.0, noncentrality);
  return boost::math::cdf(boost::math::complement(distribution, critical)) +
         boost::math::cdf(distribution, -critical);
}

std::optional<std::size_t> participants_for_power(double power, const ExpectedEffect& effect,
                                                  double alpha) {
  constexpr std::size_t most = 1'000'000;
  if (paired_t_power(most, effect, alpha) < power) {
    return std::nullopt;
  }
  std::size_t too_few = 1;
  std::size_t enough = 2;
  while (paired_t_power(enough, effect, alpha) < power) {
    too_few = enough;
    enough = std::min(most, 2 * enough);
  }
  while (enough - too_few > 1) {
    const std::size_t middle = (too_few + enough) / 2;
    (paired_t_power(middle, effect, alpha) < power ? too_few : enough) = middle;
  }
  return enough;
}

SimulatedPower simulate_power(std::size_t n, const ExpectedEffect& effect, double alpha,
                              std::size_t studies, std::uint64_t seed) {
  assert(n >= 2 && studies >= 1);
  Pcg32 generator(seed);
  std::vector<double> differences(n);
  std::size_t rejected = 0;
  for (std::size_t study = 0; study < studies; ++study) {
    for (double& difference : differences) {
      difference = effect.mean + effect.standard_deviation * generator.normal();
    }
    const std::optional<TTest> test = test_mean(differences);
    rejected += test && test->p < alpha ? 1 : 0;
  }
  return {studies, static_cast<double>(rejected) / static_cast<double>(studies),
          clopper_pearson(rejected, studies)};
}

}  // namespace foveola::analysis
