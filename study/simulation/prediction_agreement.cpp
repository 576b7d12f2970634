#include "study/simulation/prediction_agreement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

namespace foveola::study {
namespace {

using TrialKey = std::tuple<std::string, std::string, std::string>;

TrialKey key_of(const TrialRow& trial) { return {trial.participant, trial.scene, trial.method}; }

std::optional<double> time_of(const TrialRow& trial, const std::string& mark) {
  const bool is_outline = mark == "outline";
  const bool is_censored = is_outline ? trial.outline_censored : trial.material_censored;
  return is_censored ? std::nullopt : is_outline ? trial.outline_s : trial.material_s;
}

/// From 1 on; those alike share the mean of theirs.
std::vector<double> ranks_of(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
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

MarkAgreement agreement_of(const std::map<TrialKey, TrialRow>& rendered,
                           const StudyRecords& predicted, const std::string& mark,
                           const std::string& method) {
  std::vector<double> rendered_s;
  std::vector<double> predicted_s;
  std::vector<double> ratios;
  for (const TrialRow& trial : predicted.trials) {
    const auto found = rendered.find(key_of(trial));
    if (found == rendered.end() || (!method.empty() && trial.method != method)) {
      continue;
    }
    const std::optional<double> then = time_of(found->second, mark);
    const std::optional<double> now = time_of(trial, mark);
    if (then && now) {
      rendered_s.push_back(*then);
      predicted_s.push_back(*now);
      ratios.push_back(*now / *then);
    }
  }
  return {.mark = mark,
          .method = method,
          .trials = static_cast<int>(ratios.size()),
          .rendered_median_s = median_of(rendered_s),
          .predicted_median_s = median_of(predicted_s),
          .median_ratio = median_of(ratios),
          .rank_correlation = rank_correlation(rendered_s, predicted_s)};
}

}  // namespace

std::vector<MarkAgreement> prediction_agreement(const StudyRecords& rendered,
                                                const StudyRecords& predicted) {
  std::map<TrialKey, TrialRow> trials;
  for (const TrialRow& trial : rendered.trials) {
    trials.emplace(key_of(trial), trial);
  }
  std::vector<std::string> methods = {""};
  methods.insert(methods.end(), rendered.methods.begin(), rendered.methods.end());
  std::vector<MarkAgreement> agreements;
  for (const char* mark : {"outline", "material"}) {
    for (const std::string& method : methods) {
      agreements.push_back(agreement_of(trials, predicted, mark, method));
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

double median_of(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace foveola::study
