#include "study/design/balance.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace foveola::study {
namespace {

Counts no_counts(std::size_t n) { return Counts(n, std::vector<int>(n, 0)); }

Plan tests_of(const Plan& plan) {
  Plan tests;
  std::ranges::copy_if(plan, std::back_inserter(tests),
                       [](const PlannedTrial& trial) { return trial.kind == TrialKind::test; });
  return tests;
}

/// Counts a trial. `before`: the previous trial of the session; null for the first.
void count_trial(const Protocol& protocol, const PlannedTrial& trial, const PlannedTrial* before,
                 Balance& balance) {
  const std::size_t scene = scene_index(protocol, trial.scene);
  const std::size_t method = method_index(protocol, trial.method);
  ++balance.method_at[method][trial.method_position];
  ++balance.method_at_in[scene][method][trial.method_position];
  if (trial.method_position > 0) {
    ++balance.method_after[method][method_index(protocol, before->method)];
    return;
  }
  ++balance.scene_at[scene][trial.scene_position];
  if (before != nullptr) {
    ++balance.scene_after[scene][scene_index(protocol, before->scene)];
  }
}

int spread_of(const std::vector<int>& counts) {
  if (counts.empty()) {
    return 0;
  }
  const auto [smallest, largest] = std::minmax_element(counts.begin(), counts.end());
  return *largest - *smallest;
}

}  // namespace

Balance balance_of(const Protocol& protocol, const std::vector<Plan>& plans) {
  const Counts of_methods = no_counts(protocol.methods.size());
  const Counts of_scenes = no_counts(protocol.scenes.size());
  Balance balance{.method_at = of_methods,
                  .method_at_in = std::vector<Counts>(protocol.scenes.size(), of_methods),
                  .method_after = of_methods,
                  .scene_at = of_scenes,
                  .scene_after = of_scenes};
  for (const Plan& plan : plans) {
    const Plan tests = tests_of(plan);
    for (std::size_t i = 0; i < tests.size(); ++i) {
      count_trial(protocol, tests[i], i > 0 ? &tests[i - 1] : nullptr, balance);
    }
  }
  return balance;
}

int largest_difference(const Counts& counts) {
  std::vector<int> all;
  for (const std::vector<int>& row : counts) {
    all.insert(all.end(), row.begin(), row.end());
  }
  return spread_of(all);
}

int largest_difference_after(const Counts& counts) {
  std::vector<int> others;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    for (std::size_t before = 0; before < counts.size(); ++before) {
      if (before != i) {
        others.push_back(counts[i][before]);
      }
    }
  }
  return spread_of(others);
}

}  // namespace foveola::study
