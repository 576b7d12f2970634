// Compares methods, with the participant as the unit.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/dataset/fitted_model.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/primary_analysis.h"
#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/rank_tests.h"
#include "analysis/statistics/repeated_measures.h"
#include "study/protocol/protocol.h"

namespace foveola::analysis {

/// The comparison over the participants' means of the scenes in which all methods were measured.
struct CompleteCases {
  std::size_t n = 0;
  std::optional<RatioTest> ratio;  ///< Times only.
  std::optional<TTest> points;     ///< Ratings only.
};

/// One method compared with another in one measure, over all trials with both.
struct MethodComparison {
  std::string measure;  ///< The id of a mark or a rating.
  bool is_time = true;  ///< False: a rating.
  std::string method;
  std::string reference;
  bool planned = false;   ///< By the protocol; false: exploratory.
  std::size_t n = 0;      ///< Participants with a pair of trials.
  std::size_t pairs = 0;  ///< Pairs of trials with both methods, of one participant in one scene.
  std::size_t censored = 0;  ///< Pairs that are left out because of a right-censored time.

  /// Source of the comparison's estimate and P-value. All later members are sensitivity analyses.
  std::optional<PrimaryResult> primary;
  /// Holm's adjusted P of the primary analysis, over all planned comparisons together; exploratory
  /// ones are not adjusted.
  std::optional<double> p_holm;
  /// Reason why there is no primary P-value; empty if there is one.
  std::string missing;

  /// Mean of the participants' mean differences, in the unit that in_unit() converts; empty without
  /// any. A single participant, or constant differences, have a mean and no test.
  std::optional<double> mean;
  std::optional<RatioTest> ratio;     ///< Times only: method over reference.
  std::optional<Interval> ratio_bca;  ///< Times only: bootstrap interval of `ratio`.
  std::optional<TTest> points;        ///< Ratings only: method minus reference.
  // Tests of log ratios of times, or differences of ratings.
  std::optional<SignedRankTest> ranks;
  std::optional<PseudoMedian> pseudo_median;
  /// Equivalence by the primary analysis, if the plan has a margin.
  std::optional<EquivalenceTest> equivalent;
  /// Reason why there is a margin but no test of equivalence; else empty.
  std::string no_equivalence;
  /// Holm's adjusted P of equivalence, over the planned comparisons with a margin, a family of
  /// their own; exploratory ones are not adjusted.
  std::optional<double> p_equivalent_holm;
  std::optional<double> margin;  ///< a ratio above 1 for times, points for ratings
  CompleteCases complete;
  /// Influence on the primary estimate. Empty without one, for an ordinal model, with fewer than
  /// three participants, or with more than 2000, of whom none has much influence.
  std::optional<Influence> influence;
  std::string no_influence;  ///< Reason why there is none; empty if there is one.

  /// Returns the paired t test over participants, of log ratios or points.
  std::optional<TTest> t_test() const { return ratio ? std::optional(ratio->logs) : points; }

  /// Converts a tested value, or a limit, to a ratio of times or a difference of ratings.
  double in_unit(double tested) const { return is_time ? std::exp(tested) : tested; }
  Interval in_unit(const Interval& tested) const {
    return {in_unit(tested.low), in_unit(tested.high)};
  }
};

/// One test of all methods in one measure.
struct OmnibusTest {
  std::string measure;
  std::size_t left_out = 0;                  ///< Participants with a missing value.
  std::size_t censored = 0;                  ///< Right-censored times, which are left out.
  std::optional<VarianceAnalysis> variance;  ///< On log times; ratings have none.
  std::optional<FriedmanTest> ranks;
};

/// Test of whether a measure changes along the session, or with the previous method.
struct OrderTest {
  std::string measure;
  bool is_time = true;
  /// "trial in the session", "method in the scene", or for carry-over "fv after od".
  std::string of;
  std::size_t censored = 0;              ///< Right-censored times, which are left out.
  std::optional<TTest> change_per_step;  ///< Change of a time's logarithm, or of a rating.
};

struct Comparisons {
  study::AnalysisPlan plan;
  /// The planned ones in the plan's order, then the others, by measure and in the methods' order.
  std::vector<MethodComparison> methods;
  std::vector<OmnibusTest> omnibus;
  std::vector<OrderTest> order;
  FittedModels models;  ///< Models fitted by R.
  /// A sentence on the right-censored times, which only Tobit models use; empty if there are none.
  std::string censored_times;
};

/// Compares the pairs. Every planned comparison has its row, with P-values or the reason why there
/// are none; Holm's adjustment is for as many as were planned. `models`: of the same pairs, as far
/// as they were fitted.
Comparisons compare_methods(const Dataset& set, const study::AnalysisPlan& plan,
                            FittedModels models = {});

/// Returns the planned comparisons of compare_methods with their primary analyses alone.
/// Simulations of thousands of studies need no sensitivity analyses.
std::vector<MethodComparison> planned_primary_analyses(const Dataset& set,
                                                       const study::AnalysisPlan& plan,
                                                       const FittedModels& models = {});

}  // namespace foveola::analysis
