#include "analysis/statistics/student_t.h"

#include <cassert>
#include <cmath>

#include <boost/math/distributions/students_t.hpp>

namespace foveola::analysis {

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

}  // namespace foveola::analysis
