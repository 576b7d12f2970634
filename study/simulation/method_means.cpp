#include "study/simulation/method_means.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace foveola::study {
namespace {

using Times = std::map<std::pair<std::string, std::string>, double>;  // by participant and scene

Times times_of(const StudyRecords& records, const std::string& mark, const std::string& method) {
  Times times;
  for (const TrialRow& trial : records.trials) {
    const bool is_outline = mark == "outline";
    const bool censored = is_outline ? trial.outline_censored : trial.material_censored;
    const std::optional<double> time_s = is_outline ? trial.outline_s : trial.material_s;
    if (trial.method == method && time_s && !censored) {
      times.emplace(std::pair(trial.participant, trial.scene), *time_s);
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
  for (const char* mark : {"outline", "material"}) {
    const Times baseline = times_of(records, mark, records.methods.front());
    for (std::size_t i = 1; i < records.methods.size(); ++i) {
      means.push_back(mean_of(baseline, times_of(records, mark, records.methods[i])));
      means.back().mark = mark;
      means.back().method = records.methods[i];
    }
  }
  return means;
}

}  // namespace foveola::study
