#include "analysis/statistics/distributions.h"

#include <cassert>
#include <cmath>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/erf.hpp>

namespace foveola::analysis {
namespace {

constexpr double root_two = 1.41421356237309504880;

}  // namespace

double student_t_quantile(double confidence, double degrees_of_freedom) {
  assert(confidence > 0.0 && confidence < 1.0 && degrees_of_freedom > 0.0);
  const boost::math::students_t distribution(degrees_of_freedom);
  return boost::math::quantile(boost::math::complement(distribution, (1.0 - confidence) / 2.0));
}

double student_t_two_sided(double t, double degrees_of_freedom) {
  assert(!std::isnan(t) && degrees_of_freedom > 0.0);
  if (std::isinf(t)) {
    return 0.0;
  }
  const boost::math::students_t distribution(degrees_of_freedom);
  return 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

double student_t_one_sided(double t, double degrees_of_freedom) {
  assert(!std::isnan(t) && degrees_of_freedom > 0.0);
  if (std::isinf(t)) {
    return t > 0.0 ? 0.0 : 1.0;
  }
  const boost::math::students_t distribution(degrees_of_freedom);
  return boost::math::cdf(boost::math::complement(distribution, t));
}

double normal_quantile(double probability) {
  return -root_two * boost::math::erfc_inv(2.0 * probability);
}

double normal_two_sided_quantile(double confidence) {
  return root_two * boost::math::erfc_inv(1.0 - confidence);
}

double normal_cdf(double z) { return 0.5 * boost::math::erfc(-z / root_two); }

double normal_two_sided(double z) { return boost::math::erfc(std::abs(z) / root_two); }

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
