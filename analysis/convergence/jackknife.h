// The uncertainty of what is computed from several repetitions together.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A statistic of the repetitions `kept`; empty where it is not defined.
using RepetitionStatistic = std::function<std::optional<double>(std::span<const std::size_t> kept)>;

/// The statistic of all `repetitions` and its 95 % interval from the jackknife: with v_i the value
/// without repetition i, the standard error is sqrt((n - 1) / n sum (v_i - mean v)^2), and
/// Student's t has n - 1 degrees of freedom (Efron and Tibshirani 1993, "An Introduction to the
/// Bootstrap", eq. 11.5 and section 12.5). No interval with fewer than two repetitions or where
/// some v_i is not defined; empty if the statistic is not.
std::optional<Estimate> jackknife(std::size_t repetitions, const RepetitionStatistic& statistic);

/// The jackknife of a ratio (> 0), made on its logarithm.
std::optional<Estimate> jackknife_ratio(std::size_t repetitions, const RepetitionStatistic& ratio);

}  // namespace foveola::analysis
