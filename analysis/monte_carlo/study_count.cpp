#include "analysis/monte_carlo/study_count.h"

#include <cassert>
#include <cmath>

namespace foveola::analysis {

void StudyCount::add(std::optional<bool> holds) {
  studies += holds ? 1 : 0;
  hits += holds.value_or(false) ? 1 : 0;
}

void StudyCount::add(const PrimaryResult& result, double truth) {
  add(result.interval->low <= truth && truth <= result.interval->high);
  estimates.add(result.estimate);
}

void StudyCount::add(const StudyCount& other) {
  studies += other.studies;
  hits += other.hits;
  estimates.add(other.estimates);
}

double StudyCount::mean_ratio() const {
  return std::exp(estimates.rounded() / static_cast<double>(studies));
}

void add(const StudyCounts& counts, StudyCounts& sums) {
  assert(counts.size() == sums.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    sums[i].add(counts[i]);
  }
}

StudyCounts sum_of_blocks(
    std::size_t figures, std::size_t studies, std::size_t block, const Workers& workers,
    const std::function<StudyCounts(std::size_t first, std::size_t last)>& count) {
  std::vector<StudyCounts> parts((studies + block - 1) / block, StudyCounts(figures));
  workers.for_each_block(studies, block, [&](std::size_t first, std::size_t last) {
    parts[first / block] = count(first, last);
  });
  StudyCounts sums(figures);
  for (const StudyCounts& part : parts) {
    add(part, sums);
  }
  return sums;
}

}  // namespace foveola::analysis
