#include "analysis/statistics/residual_outliers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "analysis/statistics/logarithms.h"
#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

/// The effects of participants, or of conditions, and how many kept values each has.
struct Effects {
  std::vector<double> means;
  std::vector<double> counts;
};

/// The least-squares fit of an additive model to the values that are kept.
class AdditiveFit {
 public:
  explicit AdditiveFit(const std::vector<TrialValue>& values)
      : values_(values), kept_(values.size(), true), size_(values.size()) {
    for (const TrialValue& value : values) {
      count(participants_, value.participant, 1.0);
      count(conditions_, value.condition, 1.0);
    }
    fit();
  }

  void take_out(std::size_t index) {
    assert(kept_[index]);
    kept_[index] = false;
    --size_;
    count(participants_, values_[index].participant, -1.0);
    count(conditions_, values_[index].condition, -1.0);
    fit();
  }

  std::size_t size() const { return size_; }
  bool keeps(std::size_t index) const { return kept_[index]; }
  double degrees_of_freedom() const {
    return static_cast<double>(size_) - present(participants_) - present(conditions_) + 1.0;
  }
  double residual(std::size_t index) const {
    const TrialValue& value = values_[index];
    return value.value - participants_.means[value.participant] -
           conditions_.means[value.condition];
  }
  double standard_deviation() const {
    long double squares = 0.0L;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (kept_[i]) {
        squares += static_cast<long double>(residual(i)) * residual(i);
      }
    }
    return std::sqrt(static_cast<double>(squares) / degrees_of_freedom());
  }
  /// The share of a residual's variance that the fit leaves to it; 0 where the trial alone decides
  /// its own fit.
  double freedom(std::size_t index) const {
    const double of_participant = participants_.counts[values_[index].participant];
    const double of_condition = conditions_.counts[values_[index].condition];
    if (of_participant < 2.0 || of_condition < 2.0) {
      return 0.0;
    }
    return 1.0 - 1.0 / of_participant - 1.0 / of_condition + 1.0 / static_cast<double>(size_);
  }

 private:
  static void count(Effects& effects, std::size_t index, double change) {
    if (index >= effects.counts.size()) {
      effects.counts.resize(index + 1, 0.0);
      effects.means.resize(index + 1, 0.0);
    }
    effects.counts[index] += change;
  }
  static double present(const Effects& effects) {
    return static_cast<double>(std::count_if(effects.counts.begin(), effects.counts.end(),
                                             [](double count) { return count > 0.0; }));
  }

  /// Adds to the effects what the residuals of each have on average; returns the largest change.
  double sweep(Effects& effects, std::size_t TrialValue::*index) const {
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

  /// By turns: at once without missing cells, else in a few sweeps.
  void fit() {
    constexpr int most_sweeps = 200;
    constexpr double rounding = 1e-13;
    for (int i = 0; i < most_sweeps; ++i) {
      const double change = sweep(participants_, &TrialValue::participant);
      if (std::max(change, sweep(conditions_, &TrialValue::condition)) <= rounding) {
        break;
      }
    }
  }

  const std::vector<TrialValue>& values_;
  std::vector<bool> kept_;
  std::size_t size_;
  Effects participants_;
  Effects conditions_;
};

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
