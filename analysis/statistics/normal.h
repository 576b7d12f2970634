// The normal distribution, for intervals and P-values.
#pragma once

namespace foveola::analysis {

/// The z that a standard normal variable stays below with this probability, in (0, 1).
double normal_quantile(double probability);

/// The z that |Z| exceeds with probability 1 - confidence; confidence in (0, 1).
double normal_two_sided_quantile(double confidence);

/// The probability that a standard normal variable is at most z.
double normal_cdf(double z);

/// The probability that |Z| is at least |z|, accurate down to 1e-300.
double normal_two_sided(double z);

}  // namespace foveola::analysis
