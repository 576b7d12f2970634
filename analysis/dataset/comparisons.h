// Methods compared with each other, with the participant as the unit.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/statistics/equivalence.h"
#include "analysis/statistics/friedman.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/pseudo_median.h"
#include "analysis/statistics/repeated_measures.h"
#include "analysis/statistics/wilcoxon.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// One method compared with another in one measure, over the participants who have both.
struct MethodComparison {
  std::string measure;  ///< The id of a mark or a rating.
  bool is_time = true;  ///< Otherwise a rating.
  std::string method;
  std::string reference;
  bool primary = false;  ///< Planned in the protocol; otherwise exploratory.
  std::size_t n = 0;

  std::optional<RatioTest> ratio;     ///< Times only: method over reference.
  std::optional<Interval> ratio_bca;  ///< Times only: the bootstrap's interval of `ratio`.
  std::optional<TTest> points;        ///< Ratings only: method minus reference.
  // These test log ratios of times, or differences of ratings.
  std::optional<SignedRankTest> ranks;
  std::optional<PseudoMedian> pseudo_median;
  std::optional<EquivalenceTest> equivalent;  ///< Where the plan has a margin.
  std::optional<double> margin;

  /// Holm's adjusted P, over all planned comparisons together, or over the exploratory ones of the
  /// measure: of t for times, of ranks for ratings.
  std::optional<double> p_holm;
  /// Why there is no P-value; empty if there is one.
  std::string missing;

  /// A tested value, or an interval of such, as a ratio of times or a difference of ratings.
  double in_unit(double tested) const { return is_time ? std::exp(tested) : tested; }
  Interval in_unit(const Interval& tested) const {
    return {in_unit(tested.low), in_unit(tested.high)};
  }
};

/// One test of all methods in one measure.
struct OmnibusTest {
  std::string measure;
  std::size_t left_out = 0;                  ///< Participants with a missing value.
  std::optional<VarianceAnalysis> variance;  ///< On log times; ratings have none.
  std::optional<FriedmanTest> ranks;
};

/// Whether a measure changes along the session.
struct OrderTest {
  std::string measure;
  bool is_time = true;
  std::string of;                        ///< "trial in the session" or "method in the scene".
  std::optional<TTest> change_per_step;  ///< Change of a time's logarithm, or of a rating.
};

struct Comparisons {
  study::AnalysisPlan plan;
  /// First the planned ones as the plan has them, then the others, measure by measure and in the
  /// methods' order.
  std::vector<MethodComparison> methods;
  std::vector<OmnibusTest> omnibus;
  std::vector<OrderTest> order;
};

/// Compares all pairs of methods in all measures that are numbers. Of planned comparisons the plan
/// says which method is compared with which, and every one of them has its row, with P-values or
/// the reason why there are none; Holm's adjustment is for as many as were planned.
Comparisons compare_methods(const Dataset& set, const study::AnalysisPlan& plan);

}  // namespace foveola::analysis
