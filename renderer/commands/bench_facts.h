// Common parts of benchmarks' JSON: program, machine, and medians with confidence intervals.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace foveola {

/// version, compiler, build_type, instruction_set, ray_tracer.
nlohmann::ordered_json program_facts();

/// program_facts and processor, cores (usable by this process), memory_gb (10^9 bytes), system (the
/// series of the kernel), distribution and date (UTC). No name of the machine, no paths.
nlohmann::ordered_json bench_facts();

/// A single measurement, as `bench compare` reads it: {"value": 3, "low": null, "high": null}.
nlohmann::ordered_json measured_once(double value);

/// A median with a confidence interval of at least 95 %: between two of the values, by the binomial
/// distribution of the number of values below the true median (Conover 1999, "Practical
/// Nonparametric Statistics", section 3.2). Absent for fewer than six values.
struct Median {
  double value = 0.0;
  std::optional<std::pair<double, double>> interval;  ///< low and high
};

/// values: at least one. The upper median of an even number.
Median median_of(std::vector<double> values);

/// factor: positive.
Median operator*(const Median& median, double factor);
/// amount / median; the median must be positive.
Median operator/(double amount, const Median& median);

/// {"median": 3, "low": 2, "high": 4}, as `bench compare` reads it; an absent interval gives nulls.
nlohmann::ordered_json json_of(const Median& median);

}  // namespace foveola
