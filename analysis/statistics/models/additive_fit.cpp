#include "analysis/statistics/models/additive_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "analysis/statistics/distributions.h"
#include "analysis/statistics/logarithms.h"

namespace foveola::analysis {
namespace {

/// Returns the trial with the maximum studentized residual; empty if none has any freedom.
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

/// Returns the bound that the maximum of n studentized residuals exceeds with a probability of at
/// most alpha. One of them, squared and over the degrees of freedom, is t^2 / (degrees - 1 + t^2)
/// with t of Student's distribution with one degree less.
double largest_expected(double n, double degrees, double alpha) {
  const double t = student_t_quantile(1.0 - alpha / n, degrees - 1.0);
  return t * std::sqrt(degrees / (degrees - 1.0 + t * t));
}

}  // namespace

void AdditiveFit::Effects::count(std::size_t index, double change) {
  if (index >= counts.size()) {
    counts.resize(index + 1, 0.0);
    means.resize(index + 1, 0.0);
  }
  counts[index] += change;
}

double AdditiveFit::Effects::present() const {
  return static_cast<double>(
      std::ranges::count_if(counts, [](double count) { return count > 0.0; }));
}

AdditiveFit::AdditiveFit(std::vector<TrialValue> values)
    : values_(std::move(values)), kept_(values_.size(), true), size_(values_.size()) {
  double largest = 0.0;
  for (const TrialValue& value : values_) {
    participants_.count(value.participant, 1.0);
    conditions_.count(value.condition, 1.0);
    largest = std::max(largest, std::abs(value.value));
  }
  rounding_ = 4.0 * std::numeric_limits<double>::epsilon() * largest;
  fit();
}

void AdditiveFit::remove_trial(std::size_t index) {
  assert(kept_[index]);
  kept_[index] = false;
  --size_;
  participants_.count(values_[index].participant, -1.0);
  conditions_.count(values_[index].condition, -1.0);
  fit();
}

double AdditiveFit::degrees_of_freedom() const {
  return static_cast<double>(size_) - participants_.present() - conditions_.present() + 1.0;
}

double AdditiveFit::residual(std::size_t index) const {
  const TrialValue& value = values_[index];
  return value.value - participants_.means[value.participant] - conditions_.means[value.condition];
}

double AdditiveFit::standard_deviation() const {
  long double squares = 0.0L;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (kept_[i]) {
      squares += static_cast<long double>(residual(i)) * residual(i);
    }
  }
  return std::sqrt(static_cast<double>(squares) / degrees_of_freedom());
}

double AdditiveFit::freedom(std::size_t index) const {
  const double of_participant = participants_.counts[values_[index].participant];
  const double of_condition = conditions_.counts[values_[index].condition];
  if (of_participant < 2.0 || of_condition < 2.0) {
    return 0.0;
  }
  return 1.0 - 1.0 / of_participant - 1.0 / of_condition + 1.0 / static_cast<double>(size_);
}

/// Adds the mean residual of each effect to it; returns the maximum change.
double AdditiveFit::sweep(Effects& effects, std::size_t TrialValue::* index) const {
  std::vector<double> sums(effects.means.size(), 0.0);
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (kept_[i]) {
      sums[values_[i].*index] += residual(i);
    }
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (effects.counts[i] > 0.0) {
      const double change = sums[i] / effects.counts[i];
      effects.means[i] += change;
      largest = std::max(largest, std::abs(change));
    }
  }
  return largest;
}

/// Alternates participants and conditions: exact at once without missing cells, else in a few
/// sweeps.
void AdditiveFit::fit() {
  constexpr int max_sweeps = 1000;
  for (int i = 0; i < max_sweeps; ++i) {
    const double change = sweep(participants_, &TrialValue::participant);
    if (std::max(change, sweep(conditions_, &TrialValue::condition)) <= rounding_) {
      break;
    }
  }
}

std::vector<ResidualOutlier> residual_outliers(const std::vector<TrialValue>& values,
                                               double alpha) {
  AdditiveFit fit(values);
  const auto most = std::min<double>(max_residual_outliers, fit.degrees_of_freedom() / 5.0);
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
    fit.remove_trial(candidate->index);
  }
  candidates.resize(outliers);
  AdditiveFit others(values);
  for (const ResidualOutlier& outlier : candidates) {
    others.remove_trial(outlier.index);
  }
  for (ResidualOutlier& outlier : candidates) {
    outlier.deviation = others.residual(outlier.index);
  }
  return candidates;
}

}  // namespace foveola::analysis
