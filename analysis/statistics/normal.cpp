#include "analysis/statistics/normal.h"

#include <cmath>

#include <boost/math/special_functions/erf.hpp>

namespace foveola::analysis {
namespace {

constexpr double root_two = 1.41421356237309504880;

}  // namespace

double normal_quantile(double probability) {
  return -root_two * boost::math::erfc_inv(2.0 * probability);
}

double normal_two_sided_quantile(double confidence) {
  return root_two * boost::math::erfc_inv(1.0 - confidence);
}

double normal_cdf(double z) { return 0.5 * boost::math::erfc(-z / root_two); }

double normal_two_sided(double z) { return boost::math::erfc(std::abs(z) / root_two); }

}  // namespace foveola::analysis
