// The normal and Student's t distributions, and the exact interval of a proportion.
#pragma once

#include <cstddef>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Returns the t that a variable with `degrees_of_freedom` (> 0) exceeds in absolute value with
/// probability 1 - confidence; confidence in (0, 1).
double student_t_quantile(double confidence, double degrees_of_freedom);

/// Returns the probability that |T| is at least |t|: a two-sided P-value, accurate down to 1e-300.
/// 0 for infinite t.
double student_t_two_sided(double t, double degrees_of_freedom);

/// Returns the probability that T is at least t: a one-sided P-value, accurate down to 1e-300.
double student_t_one_sided(double t, double degrees_of_freedom);

/// Returns the quantile of the standard normal distribution at this probability, in (0, 1).
double normal_quantile(double probability);

/// Returns the z that |Z| exceeds with probability 1 - confidence; confidence in (0, 1).
double normal_two_sided_quantile(double confidence);

/// Returns the probability that a standard normal variable is at most z.
double normal_cdf(double z);

/// Returns the probability that |Z| is at least |z|, accurate down to 1e-300.
double normal_two_sided(double z);

/// Returns Clopper and Pearson's (1934) exact interval for `successes` of `trials`; trials >= 1.
Interval clopper_pearson(std::size_t successes, std::size_t trials,
                         double confidence = default_confidence);

}  // namespace foveola::analysis
