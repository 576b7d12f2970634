#include "analysis/statistics/equivalence.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "analysis/statistics/pseudo_median.h"
#include "analysis/statistics/ranks.h"
#include "analysis/statistics/student_t.h"
#include "analysis/statistics/wilcoxon.h"

namespace foveola::analysis {
namespace {

/// One-sided P that values shifted by `margin` are centred above zero; `sign` -1 mirrors the
/// values.
double p_of_shifted(std::span<const double> values, double sign, double margin) {
  std::vector<double> shifted;
  shifted.reserve(values.size());
  for (const double value : values) {
    shifted.push_back(sign * value + margin);
  }
  const std::optional<SignedRankTest> test = signed_rank(without_rounding(std::move(shifted)));
  return test ? test->p_above : 1.0;
}

}  // namespace

EquivalenceTest equivalence(double estimate, double standard_error, double degrees_of_freedom,
                            double margin, double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  EquivalenceTest result;
  result.p_above_low =
      student_t_one_sided((estimate + margin) / standard_error, degrees_of_freedom);
  result.p_below_high =
      student_t_one_sided((margin - estimate) / standard_error, degrees_of_freedom);
  result.p = std::max(result.p_above_low, result.p_below_high);
  const double half_width =
      student_t_quantile(1.0 - 2.0 * alpha, degrees_of_freedom) * standard_error;
  result.interval = {estimate - half_width, estimate + half_width};
  return result;
}

std::optional<EquivalenceTest> equivalence_by_ranks(std::span<const double> values, double margin,
                                                    double alpha) {
  assert(margin > 0.0 && alpha > 0.0 && alpha < 0.5);
  if (values.empty()) {
    return std::nullopt;
  }
  EquivalenceTest result;
  result.p_above_low = p_of_shifted(values, 1.0, margin);
  result.p_below_high = p_of_shifted(values, -1.0, margin);
  result.p = std::max(result.p_above_low, result.p_below_high);
  result.interval = pseudo_median(values, 1.0 - 2.0 * alpha)->interval;
  return result;
}

}  // namespace foveola::analysis
