// Plans the number of participants of a paired comparison, by formula and by simulation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Expected distribution of the differences within participants; for times, of the logarithms of
/// ratios.
struct ExpectedEffect {
  double mean = 0.0;
  double standard_deviation = 1.0;  ///< Above zero.
};

/// Returns the effect of a method that takes `percent` (above 0) of the other's time, with a
/// geometric standard deviation `spread` (above 1) of participants' ratios: two thirds lie within
/// percent / spread and percent * spread.
ExpectedEffect effect_of_ratio(double percent, double spread);

/// Returns the power of the two-sided paired t test at level alpha, counting both tails, from the
/// noncentral t distribution (like R's power.t.test with type = "paired" and strict = TRUE). n >=
/// 2, alpha in (0, 1).
double paired_t_power(std::size_t n, const ExpectedEffect& effect, double alpha = 0.05);

/// Returns the minimum number of participants, from 2, with at least this power; empty if a million
/// are too few. power and alpha in (0, 1).
std::optional<std::size_t> participants_for_power(double power, const ExpectedEffect& effect,
                                                  double alpha = 0.05);

/// Power by simulation: the share of studies of n participants with normal differences whose paired
/// t test rejects.
struct SimulatedPower {
  std::size_t studies = 0;
  double power = 0.0;
  Interval interval;  ///< Clopper-Pearson interval of the power.
};

/// Returns the power in `studies` (at least 1) of n (at least 2) participants. Equal seeds give
/// equal results. alpha: in (0, 1).
SimulatedPower simulate_power(std::size_t n, const ExpectedEffect& effect, double alpha,
                              std::size_t studies, std::uint64_t seed);

}  // namespace foveola::analysis
