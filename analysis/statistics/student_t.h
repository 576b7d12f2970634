// Student's t distribution, for intervals and P-values.
#pragma once

namespace foveola::analysis {

/// The t that a variable with `degrees_of_freedom` (> 0) exceeds in absolute value with probability
/// 1 - confidence; confidence in (0, 1).
double student_t_quantile(double confidence, double degrees_of_freedom);

/// The probability that |T| is at least |t|: a two-sided P-value, accurate down to 1e-300. 0 for
/// infinite t.
double student_t_two_sided(double t, double degrees_of_freedom);

/// The probability that T is at least t: a one-sided P-value, accurate down to 1e-300.
double student_t_one_sided(double t, double degrees_of_freedom);

}  // namespace foveola::analysis
