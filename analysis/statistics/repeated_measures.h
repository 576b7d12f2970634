// Analysis of variance of the same participants under several conditions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foveola::analysis {

/// One value per participant and condition, without gaps.
struct RepeatedMeasures {
  std::size_t participants = 0;
  std::size_t conditions = 0;
  std::vector<double> values;  ///< [participant][condition]

  double at(std::size_t participant, std::size_t condition) const {
    return values[participant * conditions + condition];
  }
  std::span<const double> of(std::size_t participant) const {
    return std::span(values).subspan(participant * conditions, conditions);
  }
};

/// Returns the participants with a value under every condition, in their order; rows are
/// [participant][condition] and equally long. Participants with a missing value are left out, as
/// these tests need; their number is the difference to rows.size().
RepeatedMeasures complete_participants(const std::vector<std::vector<std::optional<double>>>& rows);

struct VarianceAnalysis {
  std::size_t participants = 0;
  std::size_t conditions = 0;
  double f = 0.0;
  double degrees_of_freedom = 0.0;  ///< Uncorrected degrees of freedom of the conditions.
  double residual_degrees_of_freedom = 0.0;
  double p = 0.0;  ///< Assumes that all differences have equal variances (sphericity).
  /// Epsilon, the departure from sphericity: 1 down to 1 / (conditions - 1) (Box 1954; Greenhouse,
  /// Geisser 1959).
  double greenhouse_geisser = 1.0;
  double p_greenhouse_geisser = 0.0;  ///< With both degrees of freedom times epsilon.
  /// Epsilon corrected for its bias near sphericity (Huynh, Feldt 1976), at most 1.
  double huynh_feldt = 1.0;
  double p_huynh_feldt = 0.0;
  double partial_eta_squared = 0.0;
};

/// Analyses one within-participant factor. Empty if F is not defined: fewer than two participants
/// or conditions, or no residual variance.
std::optional<VarianceAnalysis> repeated_measures_anova(const RepeatedMeasures& data);

}  // namespace foveola::analysis
