// Methods compared with each other, with the participant as the unit.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/publication/analysis_set.h"
#include "analysis/statistics/equivalence.h"
#include "analysis/statistics/friedman.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/pseudo_median.h"
#include "analysis/statistics/repeated_measures.h"
#include "analysis/statistics/wilcoxon.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// The name of the measure of ratings; the others are those of marks.
inline constexpr const char* artifacts_measure = "artifacts";

/// One method compared with another in one measure, over the participants who have both.
struct MethodComparison {
  std::string measure;  ///< A mark's name, or "artifacts".
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

  /// Holm's adjusted P, over the primary comparisons together, or over the exploratory ones of the
  /// measure: of t for times, of ranks for ratings.
  std::optional<double> p_holm;

  bool is_of_ratings() const { return measure == artifacts_measure; }
  /// A tested value, or an interval of such, as a ratio of times or a difference of ratings.
  double in_unit(double tested) const { return is_of_ratings() ? tested : std::exp(tested); }
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
  Mark mark = Mark::outline;
  std::string of;                        ///< "trial in the session" or "method in the scene".
  std::optional<TTest> change_per_step;  ///< Change of the logarithm of the time.
};

struct Comparisons {
  study::AnalysisPlan plan;
  std::vector<MethodComparison> methods;  ///< Measure by measure; pairs in the protocol's order.
  std::vector<OmnibusTest> omnibus;
  std::vector<OrderTest> order;
};

Comparisons compare_methods(const AnalysisSet& set, const study::AnalysisPlan& plan);

}  // namespace foveola::analysis
