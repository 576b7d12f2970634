#include "analysis/statistics/residual_outliers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/statistics/additive_fit.h"
#include "analysis/statistics/logarithms.h"
#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

/// The trial with the largest studentized residual; empty where none has any freedom.
std::optional<ResidualOutlier> farthest(const AdditiveFit& fit, std::size_t values,
                                        double standard_deviation) {
  std::optional<ResidualOutlier> found;
  for (std::size_t i = 0; i < values; ++i) {
    const double freedom = fit.keeps(i) ? fit.freedom(i) : 0.0;
    if (freedom > 0.0) {
      const double studentized = fit.residual(i) / (standard_deviation * std::sqrt(freedom));
      if (!found || std::abs(studentized) > std::abs(found->studentized)) {
        found = ResidualOutlier{i, 0.0, studentized};
      }
    }
  }
  return found;
}

/// What the largest of n studentized residuals exceeds with a probability of at most alpha. One of
/// them, squared and over the degrees of freedom, is t^2 / (degrees - 1 + t^2) with t of Student's
/// distribution of one degree less.
double largest_expected(double n, double degrees, double alpha) {
  const double t = student_t_quantile(1.0 - alpha / n, degrees - 1.0);
  return t * std::sqrt(degrees / (degrees - 1.0 + t * t));
}

}  // namespace

std::vector<ResidualOutlier> residual_outliers(const std::vector<TrialValue>& values,
                                               double alpha) {
  AdditiveFit fit(values);
  const auto most = std::min<double>(most_residual_outliers, fit.degrees_of_freedom() / 5.0);
  std::vector<ResidualOutlier> candidates;
  std::size_t outliers = 0;
  while (static_cast<double>(candidates.size()) + 1.0 <= most) {
    const double degrees = fit.degrees_of_freedom();
    const double deviation = degrees >= 2.0 ? fit.standard_deviation() : 0.0;
    if (deviation <= rounding_of_logarithms) {
      break;
    }
    const std::optional<ResidualOutlier> candidate = farthest(fit, values.size(), deviation);
    if (!candidate) {
      break;
    }
    candidates.push_back(*candidate);
    const double limit = largest_expected(static_cast<double>(fit.size()), degrees, alpha);
    if (std::abs(candidate->studentized) > limit) {
      outliers = candidates.size();
    }
    fit.take_out(candidate->index);
  }
  candidates.resize(outliers);
  AdditiveFit others(values);
  for (const ResidualOutlier& outlier : candidates) {
    others.take_out(outlier.index);
  }
  for (ResidualOutlier& outlier : candidates) {
    outlier.deviation = others.residual(outlier.index);
  }
  return candidates;
}

}  // namespace foveola::analysis
