// What benchmarks' JSON has in common: program, machine, and medians with their intervals.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace foveola {

/// version, compiler, build_type, instruction_set, ray_tracer.
nlohmann::ordered_json program_facts();

/// The same, and processor, cores (those that this process may use), memory_gb (10^9 bytes), system
/// (the series of the kernel), distribution and date (UTC). No name of the machine, no paths.
nlohmann::ordered_json bench_facts();

/// A measured figure that was measured once, as `bench compare` reads it: {"value": 3, "low": null,
/// "high": null}.
nlohmann::ordered_json measured_once(double value);

/// A median, and where the true one lies with at least 95 % confidence: between two of the values,
/// for as many of n lie below it as tosses of a coin (Conover 1999, "Practical Nonparametric
/// Statistics", section 3.2). Fewer than six values say too little.
struct Median {
  double value = 0.0;
  std::optional<std::pair<double, double>> interval;  ///< low and high
};

/// values: at least one; the upper of the two in the middle of an even number.
Median median_of(std::vector<double> values);

/// factor: positive.
Median operator*(const Median& median, double factor);
/// amount / median; the median must be positive.
Median operator/(double amount, const Median& median);

/// {"median": 3, "low": 2, "high": 4}, as `bench compare` reads it; ends that are not known are
/// null.
nlohmann::ordered_json json_of(const Median& median);

}  // namespace foveola
