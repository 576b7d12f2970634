// What participants and conditions make one expect of a trial, without their interaction.
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

  /// Fits anew without a trial that was kept.
  void take_out(std::size_t index);

  std::size_t size() const { return size_; }  ///< Number of trials kept.
  bool keeps(std::size_t index) const { return kept_[index]; }
  /// Residual degrees of freedom, where all participants are connected by conditions.
  double degrees_of_freedom() const;
  /// A trial's deviation from the fit, whether it is kept or not.
  double residual(std::size_t index) const;
  /// Residual standard deviation of the trials kept; needs a degree of freedom.
  double standard_deviation() const;
  /// The share of a kept trial's residual variance that the fit leaves to it, one less its
  /// leverage in a complete design: 1 - 1 / n_participant - 1 / n_condition + 1 / n. 0 where the
  /// trial alone decides a part of its fit.
  double freedom(std::size_t index) const;

 private:
  /// The effects of participants, or of conditions, and how many kept trials each has.
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

}  // namespace foveola::analysis
