// The mixed model of paired log times with participants and scenes crossed, and each participant's
// influence on an estimate.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"
#include "analysis/statistics/repeated_measures.h"

namespace foveola::analysis {

/// Test and interval of the mean log ratio of a crossed model.
struct CrossedTest {
  double standard_error = 0.0;
  double degrees_of_freedom = 0.0;  ///< Satterthwaite's; not a whole number in general.
  double t = 0.0;
  double p = 0.0;     ///< Two-sided, of the hypothesis that the mean is 0.
  Interval interval;  ///< Interval of the mean log ratio.
};

/// Estimates of d[p][s] = mean + P_p + S_s + e_ps by restricted maximum likelihood.
struct CrossedModel {
  std::size_t participants = 0;
  std::size_t scenes = 0;
  double mean = 0.0;                  ///< The mean log ratio.
  double participant_variance = 0.0;  ///< Between participants, in their gain; 0 at the boundary.
  double scene_variance = 0.0;        ///< Between scenes, in their gain; 0 at the boundary.
  double residual_variance = 0.0;     ///< Residual variance of one difference.
  std::optional<CrossedTest> test;    ///< Empty if the differences do not vary.
};

/// Fits the model to the differences of log times, method minus baseline, of each participant
/// (rows) and scene (conditions), without gaps. Participants and scenes are random: the interval
/// generalises to others. With fixed scenes, use test_ratio of the participants' mean differences.
///
/// It is the comparison of two methods in `log time ~ method + (1|participant) +
/// (1|participant:method) + (1|scene) + (1|scene:method) + (1|participant:scene)`; its
/// participant_variance, scene_variance and residual_variance are each twice the variances of
/// participant:method, scene:method and the residual there. Without (1|participant:scene) that
/// model would take part of its residual from the sums of both times, and differ a little.
///
/// In the balanced design the estimates are of closed form (Searle, Casella, McCulloch 1992,
/// "Variance Components", sections 4.6 and 4.7): the mean squares of participants, scenes and
/// residual estimate their expectations; a component that would be negative is 0, and its mean
/// square is pooled with the residual's (Thompson 1962, "The problem of negative estimates of
/// variance components"), the smallest first. The variance of the mean is that of (MS_participants
/// + MS_scenes - MS_residual) / (participants x scenes), with these pooled mean squares, and has
/// Satterthwaite's (1946) degrees of freedom (sum c MS)^2 / sum((c MS)^2 / df), where a component
/// at 0 counts as known: scenes - 1, participants - 1 or, with both at 0, participants x scenes -
/// 1. All of it equals lme4 and lmerTest, at the boundary too. Kenward and Roger's (1997) method
/// has the same standard error, and fewer degrees of freedom only at the boundary, where the
/// interval covers too often already: see data/golden/README.md.
///
/// Empty with fewer than two participants or two scenes.
std::optional<CrossedModel> crossed_model(const RepeatedMeasures& log_ratios,
                                          double confidence = default_confidence);

/// The estimate without each participant in turn. Participants are indices into the given values.
struct LeaveOneOut {
  Interval estimates;            ///< The minimum and maximum of the estimates.
  std::size_t without_low = 0;   ///< The participant left out for the minimum.
  std::size_t without_high = 0;  ///< The participant left out for the maximum.
};

/// Calls `estimate` with the others' values. Empty with fewer than two values.
std::optional<LeaveOneOut> leave_one_out(
    std::span<const double> values, const std::function<double(std::span<const double>)>& estimate);

}  // namespace foveola::analysis
