#include "study/simulation/prediction_agreement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "renderer/base/numbers/quantile.h"

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

/// Participant, scene, method and mark.
using TimeKey = std::tuple<std::string, std::string, std::string, std::string>;
using TimesByTrial = std::map<TimeKey, double>;

TimesByTrial measured_times(const StudyRecords& records) {
  TimesByTrial times;
  for (std::size_t row = 0; row < records.trials.size(); ++row) {
    const TrialRow& trial = records.trials[row];
    for (std::size_t measure = 0; measure < records.measures.size(); ++measure) {
      const Value& value = records.value(row, measure);
      if (StudyRecords::is_result(trial) && value.is_measured() &&
          records.measures[measure].kind == MeasureKind::time) {
        times.emplace(TimeKey(records.participant_of(trial), records.scenes[trial.scene],
                              records.methods[trial.method], records.measures[measure].id()),
                      value.number);
      }
    }
  }
  return times;
}

/// Returns ranks from 1 on, with mean ranks of ties.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]]) {
      ++end;
    }
    for (std::size_t i = begin; i < end; ++i) {
      ranks[order[i]] = 0.5 * static_cast<double>(begin + end + 1);
    }
    begin = end;
  }
  return ranks;
}

MarkAgreement agreement_of(const TimesByTrial& rendered, const TimesByTrial& predicted,
                           const std::string& mark, const std::string& method) {
  std::vector<double> rendered_s;
  std::vector<double> predicted_s;
  std::vector<double> ratios;
  for (const auto& [key, now_s] : predicted) {
    const auto found = rendered.find(key);
    if (std::get<3>(key) == mark && (method.empty() || std::get<2>(key) == method) &&
        found != rendered.end()) {
      rendered_s.push_back(found->second);
      predicted_s.push_back(now_s);
      ratios.push_back(now_s / found->second);
    }
  }
  return {.mark = mark,
          .method = method,
          .trials = static_cast<int>(ratios.size()),
          .rendered_median_s = median(rendered_s).value_or(0.0),
          .predicted_median_s = median(predicted_s).value_or(0.0),
          .median_ratio = median(ratios).value_or(0.0),
          .rank_correlation = rank_correlation(rendered_s, predicted_s)};
}

}  // namespace

std::vector<MarkAgreement> prediction_agreement(const StudyRecords& rendered,
                                                const StudyRecords& predicted) {
  const TimesByTrial rendered_times = measured_times(rendered);
  const TimesByTrial predicted_times = measured_times(predicted);
  std::vector<std::string> methods = {""};
  methods.insert(methods.end(), rendered.methods.begin(), rendered.methods.end());
  std::vector<MarkAgreement> agreements;
  for (const Measure& measure : rendered.measures) {
    if (measure.kind == MeasureKind::time) {
      for (const std::string& method : methods) {
        agreements.push_back(agreement_of(rendered_times, predicted_times, measure.id(), method));
      }
    }
  }
  return agreements;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const std::vector<double> ranks_a = ranks_of(a);
  const std::vector<double> ranks_b = ranks_of(b);
  const double mean = 0.5 * (static_cast<double>(a.size()) + 1.0);
  double product = 0.0;
  double square_a = 0.0;
  double square_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += (ranks_a[i] - mean) * (ranks_b[i] - mean);
    square_a += (ranks_a[i] - mean) * (ranks_a[i] - mean);
    square_b += (ranks_b[i] - mean) * (ranks_b[i] - mean);
  }
  return square_a > 0.0 && square_b > 0.0 ? product / std::sqrt(square_a * square_b) : 0.0;
}

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
