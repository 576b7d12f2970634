// Method against method, with the participant as the unit: what the study shows, and how surely.
#pragma once

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

/// The measure of ratings, beside the names of marks.
inline constexpr const char* artifacts_measure = "artifacts";

/// One method against another in one measure, over the participants who have both.
struct MethodComparison {
  std::string measure;  ///< a mark's name or "artifacts"
  std::string method;
  std::string reference;
  bool primary = false;  ///< planned in the protocol; otherwise exploratory
  std::size_t n = 0;

  std::optional<RatioTest> ratio;             ///< of times: method over reference
  std::optional<Interval> ratio_bca;          ///< of the same geometric mean
  std::optional<TTest> points;                ///< of ratings: method minus reference
  std::optional<SignedRankTest> ranks;        ///< of log ratios or rating differences; exact
  std::optional<PseudoMedian> pseudo_median;  ///< of log ratios or rating differences
  std::optional<EquivalenceTest> equivalent;  ///< where the plan has a margin
  std::optional<double> margin;

  /// Holm's, over the primary comparisons together, or over the exploratory ones of the measure:
  /// of t for times, of ranks for ratings.
  std::optional<double> p_holm;
};

/// All methods of one measure at once.
struct OmnibusTest {
  std::string measure;
  std::size_t left_out = 0;                  ///< participants with a gap
  std::optional<VarianceAnalysis> variance;  ///< of log times; not of ratings
  std::optional<FriedmanTest> ranks;
};

/// Whether a measure changes along the session.
struct OrderTest {
  Mark mark = Mark::outline;
  std::string of;                        ///< "trial in the session" or "method in the scene"
  std::optional<TTest> change_per_step;  ///< of the logarithm of the time
};

struct Comparisons {
  study::AnalysisPlan plan;
  std::vector<MethodComparison> methods;  ///< measure by measure; pairs in the protocol's order
  std::vector<OmnibusTest> omnibus;
  std::vector<OrderTest> order;
};

Comparisons compare_methods(const AnalysisSet& set, const study::AnalysisPlan& plan);

}  // namespace foveola::analysis
