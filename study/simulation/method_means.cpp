#include "study/simulation/method_means.h"

#include <cmath>
#include <map>
#include <utility>

namespace foveola::study {
namespace {

using Times = std::map<std::pair<std::uint32_t, std::uint16_t>, double>;  // by session and scene

Times times_of(const StudyRecords& records, std::size_t measure, std::size_t method) {
  Times times;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    const TrialRow& trial = records.trials[row];
    const Value& time = records.value(row, measure);
    if (StudyRecords::is_result(trial) && trial.method == method && time.is_measured()) {
      times.emplace(std::pair(trial.session, trial.scene), time.number);
    }
  }
  return times;
}

MethodMean mean_of(const Times& baseline, const Times& times) {
  MethodMean mean;
  double log_baseline = 0.0;
  double log_ratio = 0.0;
  for (const auto& [place, time_s] : times) {
    if (const auto compared = baseline.find(place); compared != baseline.end()) {
      log_baseline += std::log(compared->second);
      log_ratio += std::log(time_s / compared->second);
      ++mean.pairs;
    }
  }
  if (mean.pairs > 0) {
    mean.baseline_s = std::exp(log_baseline / mean.pairs);
    mean.percent = 100.0 * std::exp(log_ratio / mean.pairs);
  }
  return mean;
}

}  // namespace

std::vector<MethodMean> method_means(const StudyRecords& records) {
  std::vector<MethodMean> means;
  for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
    if (records.measures[measure].kind != MeasureKind::time) {
      continue;
    }
    const Times baseline = times_of(records, measure, 0);
    for (std::size_t method = 1; method < records.methods.size(); ++method) {
      means.push_back(mean_of(baseline, times_of(records, measure, method)));
      means.back().mark = records.measures[measure].id();
      means.back().method = records.methods[method];
    }
  }
  return means;
}

}  // namespace foveola::study
