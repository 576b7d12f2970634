#include "analysis/statistics/influence.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "analysis/statistics/crossed_model.h"
#include "analysis/statistics/paired_t.h"

namespace foveola::analysis {
namespace {

struct Result {
  double estimate = 0.0;
  std::optional<double> p;
};

/// `result_without` a participant, of each.
template <typename ResultWithout>
LeaveOneOut range_of(std::size_t participants, const ResultWithout& result_without) {
  LeaveOneOut range;
  for (std::size_t participant = 0; participant < participants; ++participant) {
    const Result result = result_without(participant);
    if (participant == 0) {
      range.estimates = {result.estimate, result.estimate};
      range.p = result.p ? std::optional(Interval{*result.p, *result.p}) : std::nullopt;
      continue;
    }
    if (result.estimate < range.estimates.low) {
      range.estimates.low = result.estimate;
      range.without_low = participant;
    }
    if (result.estimate > range.estimates.high) {
      range.estimates.high = result.estimate;
      range.without_high = participant;
    }
    range.p = range.p && result.p ? std::optional(Interval{std::min(range.p->low, *result.p),
                                                           std::max(range.p->high, *result.p)})
                                  : std::nullopt;
  }
  return range;
}

}  // namespace

std::optional<LeaveOneOut> leave_one_out(std::span<const double> log_ratios) {
  if (log_ratios.size() < 2) {
    return std::nullopt;
  }
  // The first participant is left out first; then each takes the place of the next.
  std::vector<double> others(log_ratios.begin() + 1, log_ratios.end());
  return range_of(log_ratios.size(), [&](std::size_t participant) {
    if (participant > 0) {
      others[participant - 1] = log_ratios[participant - 1];
    }
    const std::optional<RatioTest> test = ratio_t(others);
    return Result{*mean(others), test ? std::optional(test->logs.p) : std::nullopt};
  });
}

std::optional<LeaveOneOut> leave_one_out(const RepeatedMeasures& log_ratios) {
  const std::vector<CrossedModel> models = crossed_models_without_each(log_ratios);
  if (models.empty()) {
    return std::nullopt;
  }
  return range_of(models.size(), [&](std::size_t participant) {
    const CrossedModel& model = models[participant];
    return Result{model.mean, model.test ? std::optional(model.test->p) : std::nullopt};
  });
}

}  // namespace foveola::analysis
