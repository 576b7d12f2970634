#include "analysis/convergence/jackknife.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/statistics/student_t.h"

namespace foveola::analysis {
namespace {

/// Half of the interval's width.
std::optional<double> half_width(const std::vector<std::size_t>& all,
                                 const RepetitionStatistic& statistic) {
  const auto n = static_cast<double>(all.size());
  if (all.size() < 2) {
    return std::nullopt;
  }
  std::vector<double> values;
  for (const std::size_t left_out : all) {
    std::vector<std::size_t> kept = all;
    std::erase(kept, left_out);
    const std::optional<double> value = statistic(kept);
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  const double mean_value = *mean(values);
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean_value) * (value - mean_value);
  }
  return student_t_quantile(default_confidence, n - 1.0) * std::sqrt((n - 1.0) / n * squares);
}

}  // namespace

std::optional<Estimate> jackknife(std::size_t repetitions, const RepetitionStatistic& statistic) {
  std::vector<std::size_t> all(repetitions);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::optional<double> value = repetitions > 0 ? statistic(all) : std::nullopt;
  if (!value) {
    return std::nullopt;
  }
  Estimate estimate{.n = repetitions, .value = *value, .interval = {}};
  if (const std::optional<double> half = half_width(all, statistic)) {
    estimate.interval = Interval{*value - *half, *value + *half};
  }
  return estimate;
}

std::optional<Estimate> jackknife_ratio(std::size_t repetitions, const RepetitionStatistic& ratio) {
  std::optional<Estimate> estimate =
      jackknife(repetitions, [&](std::span<const std::size_t> kept) -> std::optional<double> {
        const std::optional<double> value = ratio(kept);
        return value ? std::optional(std::log(*value)) : std::nullopt;
      });
  if (estimate) {
    estimate->value = std::exp(estimate->value);
    if (estimate->interval) {
      estimate->interval->low = std::exp(estimate->interval->low);
      estimate->interval->high = std::exp(estimate->interval->high);
    }
  }
  return estimate;
}

}  // namespace foveola::analysis
