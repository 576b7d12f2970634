// Fits an additive model of participants and conditions, and finds outlying trials.
#pragma once

#include <cstddef>
#include <vector>

namespace foveola::analysis {

/// One trial's value, as the logarithm of its time.
struct TrialValue {
  std::size_t participant = 0;
  std::size_t condition = 0;  ///< Index of the scene and method together.
  double value = 0.0;
};

/// The least-squares fit of value = participant + condition to the trials that are kept, at first
/// all. Cells may be missing or repeated.
class AdditiveFit {
 public:
  explicit AdditiveFit(std::vector<TrialValue> values);

  /// Fits anew without a kept trial.
  void remove_trial(std::size_t index);

  std::size_t size() const { return size_; }  ///< Number of trials kept.
  bool keeps(std::size_t index) const { return kept_[index]; }
  /// Returns the residual degrees of freedom, if all participants are connected by conditions.
  double degrees_of_freedom() const;
  /// Returns a trial's deviation from the fit, whether it is kept or not.
  double residual(std::size_t index) const;
  /// Returns the residual standard deviation of the kept trials; needs a degree of freedom.
  double standard_deviation() const;
  /// Returns the factor of a kept trial's residual variance, 1 less its leverage in a complete
  /// design: 1 - 1 / n_participant - 1 / n_condition + 1 / n. 0 if the trial alone determines a
  /// part of its fit.
  double freedom(std::size_t index) const;

 private:
  /// Effects of participants, or of conditions, and their numbers of kept trials.
  struct Effects {
    std::vector<double> means;
    std::vector<double> counts;

    void count(std::size_t index, double change);
    double present() const;
  };

  double sweep(Effects& effects, std::size_t TrialValue::* index) const;
  void fit();

  std::vector<TrialValue> values_;
  std::vector<bool> kept_;
  std::size_t size_;
  double rounding_ = 0.0;
  Effects participants_;
  Effects conditions_;
};

struct ResidualOutlier {
  std::size_t index = 0;     ///< Index of the trial in the given values.
  double deviation = 0.0;    ///< From the fit without outliers, in the values' unit.
  double studentized = 0.0;  ///< Studentized residual at its removal.
};

/// Maximum number of outliers.
inline constexpr std::size_t max_residual_outliers = 20;

/// Returns the trials that do not fit an additive model of participants and conditions with normal
/// residuals, the most distant first, by the generalized extreme studentized residual (Paul and
/// Fung 1991, Technometrics 33; Rosner's 1983 method in a linear model). The trial with the maximum
/// studentized residual is removed and the model fitted anew, `max_residual_outliers` times or up
/// to a fifth of the residual degrees of freedom. The outliers are those up to the last that
/// exceeded its limit, the Bonferroni bound of the maximum at level alpha. So outliers do not mask
/// each other, and about a share alpha of studies with normal residuals has any. Cells may be
/// missing or repeated; leverages are those of a complete design, 1 / n_participant + 1 /
/// n_condition - 1 / n. Empty if the values do not vary beyond the model.
std::vector<ResidualOutlier> residual_outliers(const std::vector<TrialValue>& values,
                                               double alpha = 0.05);

}  // namespace foveola::analysis
