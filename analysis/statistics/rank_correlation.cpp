#include "analysis/statistics/rank_correlation.h"

#include <cmath>

#include "analysis/statistics/normal.h"
#include "analysis/statistics/ranks.h"

namespace foveola::analysis {

std::optional<Correlation> spearman(std::span<const double> x, std::span<const double> y,
                                    double confidence) {
  std::optional<Correlation> result = pearson(rank(x).ranks, rank(y).ranks, confidence);
  if (result && result->interval) {
    const double z = std::atanh(result->r);
    const double error =
        std::sqrt((1.0 + result->r * result->r / 2.0) / (static_cast<double>(result->n) - 3.0));
    const double half_width = normal_two_sided_quantile(confidence) * error;
    result->interval = {std::tanh(z - half_width), std::tanh(z + half_width)};
  }
  return result;
}

}  // namespace foveola::analysis
