#include "analysis/monte_carlo/study_power.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/dataset.h"
#include "analysis/statistics/distributions.h"
#include "renderer/base/work/parallel.h"

namespace foveola::analysis {
namespace {

/// [mark][method]
using Counts = std::vector<std::vector<std::size_t>>;

struct Tally {
  StudyPower power;
  std::size_t analysed = 0;
  Counts times;
  Counts censored;
};

Tally empty_tally(const ExpectedStudy& expected, std::size_t participants) {
  const study::Protocol& protocol = expected.protocol;
  const Counts none(protocol.marks.size(), std::vector<std::size_t>(protocol.methods.size(), 0));
  Tally tally;
  tally.power.participants = participants;
  tally.power.comparisons.resize(protocol.analysis.primary.size());
  tally.times = none;
  tally.censored = none;
  return tally;
}

void count_times(const Dataset& set, Tally& tally) {
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        for (std::size_t mark = 0; mark < tally.times.size(); ++mark) {
          const Value& value = set.value(participant, scene, method, mark);
          tally.times[mark][method] += 1;
          tally.censored[mark][method] += value.state == Value::State::right_censored ? 1 : 0;
        }
      }
    }
  }
}

bool is_significant(const MethodComparison& comparison, double alpha) {
  return comparison.p_holm && *comparison.p_holm < alpha;
}

void count_study(const study::StudyRecords& records, const FittedModels& models, Tally& tally) {
  ++tally.power.studies;
  if (std::ranges::none_of(records.sessions,
                           [](const study::SessionRow& row) { return row.state == "completed"; })) {
    return;  // All withdrew: no analysis, no significance.
  }
  const Dataset set = select_for_analysis(records);
  tally.analysed += set.participants.size();
  count_times(set, tally);
  const study::AnalysisPlan& plan = records.protocol.analysis;
  const std::vector<MethodComparison> found = planned_primary_analyses(set, plan, models);
  for (std::size_t i = 0; i < found.size(); ++i) {
    ComparisonPower& power = tally.power.comparisons[i];
    power.significant += is_significant(found[i], plan.alpha) ? 1 : 0;
    if (found[i].primary) {
      ++power.analyses[found[i].primary->kind];
      power.stand_ins += found[i].primary->instead.empty() ? 0 : 1;
    }
  }
  tally.power.all_significant +=
      std::ranges::all_of(
          found, [&](const MethodComparison& row) { return is_significant(row, plan.alpha); })
          ? 1
          : 0;
}

Tally simulate_block(const ExpectedStudy& expected, std::size_t participants,
                     const PowerSimulation& simulation, std::size_t first, std::size_t last) {
  std::vector<study::StudyRecords> studies;
  for (std::size_t study = first; study < last; ++study) {
    studies.push_back(draw_study(expected, participants, (simulation.seed << 32U) + study));
  }
  const std::vector<FittedModels> models = simulation.fit_models
                                               ? simulation.fit_models(studies)
                                               : std::vector<FittedModels>(studies.size());
  Tally tally = empty_tally(expected, participants);
  for (std::size_t i = 0; i < studies.size(); ++i) {
    count_study(studies[i], models[i], tally);
  }
  return tally;
}

void add(const Counts& counts, Counts& sums) {
  for (std::size_t mark = 0; mark < sums.size(); ++mark) {
    std::transform(counts[mark].begin(), counts[mark].end(), sums[mark].begin(), sums[mark].begin(),
                   std::plus<>());
  }
}

void add(const Tally& part, Tally& sum) {
  sum.power.studies += part.power.studies;
  sum.power.all_significant += part.power.all_significant;
  sum.analysed += part.analysed;
  for (std::size_t i = 0; i < part.power.comparisons.size(); ++i) {
    ComparisonPower& to = sum.power.comparisons[i];
    const ComparisonPower& from = part.power.comparisons[i];
    to.significant += from.significant;
    to.stand_ins += from.stand_ins;
    for (const auto& [kind, count] : from.analyses) {
      to.analyses[kind] += count;
    }
  }
  add(part.times, sum.times);
  add(part.censored, sum.censored);
}

StudyPower power_of(const Tally& tally) {
  StudyPower power = tally.power;
  power.analysed = static_cast<double>(tally.analysed) / static_cast<double>(power.studies);
  for (std::size_t mark = 0; mark < tally.times.size(); ++mark) {
    std::vector<double> shares;
    for (std::size_t method = 0; method < tally.times[mark].size(); ++method) {
      const auto times = static_cast<double>(std::max<std::size_t>(tally.times[mark][method], 1));
      shares.push_back(static_cast<double>(tally.censored[mark][method]) / times);
    }
    power.censored.push_back(std::move(shares));
  }
  return power;
}

double share_of_hits(const StudyPower& power, std::optional<std::size_t> comparison) {
  return static_cast<double>(hits_of(power, comparison)) / static_cast<double>(power.studies);
}

std::vector<std::optional<std::size_t>> criteria_of(const ExpectedStudy& expected) {
  std::vector<std::optional<std::size_t>> criteria = {std::nullopt};
  for (std::size_t i = 0; i < expected.protocol.analysis.primary.size(); ++i) {
    criteria.emplace_back(i);
  }
  return criteria;
}

using Sizes = std::map<std::size_t, StudyPower>;

/// Returns the number halfway between the minimum that reaches the target and the next lower one
/// tried; empty if there is none between, or the target is not reached.
std::optional<std::size_t> size_between(const Sizes& sizes, std::optional<std::size_t> criterion,
                                        double target) {
  std::optional<std::size_t> enough;
  for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
    if (share_of_hits(size->second, criterion) < target) {
      return enough && *enough - size->first > 1 ? std::optional((*enough + size->first) / 2)
                                                 : std::nullopt;
    }
    enough = size->first;
  }
  return std::nullopt;
}

std::vector<std::size_t> coarse_sizes(const PowerTarget& target) {
  std::vector<std::size_t> sizes;
  for (const std::size_t size : {4U, 8U, 12U, 16U, 24U, 32U, 48U, 64U, 96U, 128U, 192U, 256U, 384U,
                                 512U, 768U, 1024U, 2048U, 4096U}) {
    if (size < target.most) {
      sizes.push_back(size);
    }
  }
  sizes.push_back(target.most);
  return sizes;
}

}  // namespace

PowerShare share_of(std::size_t hits, const StudyPower& power) {
  return {static_cast<double>(hits) / static_cast<double>(power.studies),
          clopper_pearson(hits, power.studies)};
}

std::size_t hits_of(const StudyPower& power, std::optional<std::size_t> comparison) {
  return comparison ? power.comparisons[*comparison].significant : power.all_significant;
}

std::optional<StudyPower> simulate_study_power(const ExpectedStudy& expected,
                                               std::size_t participants,
                                               const PowerSimulation& simulation,
                                               const std::stop_token& stop) {
  assert(simulation.studies > 0);
  constexpr std::size_t block = studies_drawn_together;
  std::vector<Tally> parts((simulation.studies + block - 1) / block);
  Workers(simulation.threads)
      .for_each_block(simulation.studies, block, [&](std::size_t first, std::size_t last) {
        if (!stop.stop_requested()) {
          parts[first / block] = simulate_block(expected, participants, simulation, first, last);
        }
      });
  if (stop.stop_requested()) {
    return std::nullopt;
  }
  Tally sum = empty_tally(expected, participants);
  for (const Tally& part : parts) {
    add(part, sum);
  }
  return power_of(sum);
}

std::vector<StudyPower> power_curve(const ExpectedStudy& expected, const PowerTarget& target,
                                    const PowerSimulation& simulation,
                                    const std::function<void(std::size_t)>& on_size,
                                    const std::stop_token& stop) {
  Sizes sizes;
  const auto simulate = [&](std::size_t participants) {
    on_size(participants);
    if (const auto power = simulate_study_power(expected, participants, simulation, stop)) {
      sizes.emplace(participants, *power);
    }
    return !stop.stop_requested();
  };
  for (const std::size_t size : coarse_sizes(target)) {
    if (!simulate(size)) {
      return {};
    }
    if (share_of_hits(sizes.at(size), std::nullopt) >= target.power) {
      break;
    }
  }
  if (target.planned && !sizes.contains(*target.planned) && !simulate(*target.planned)) {
    return {};
  }
  for (const std::optional<std::size_t> criterion : criteria_of(expected)) {
    while (const auto size = size_between(sizes, criterion, target.power)) {
      if (!simulate(*size)) {
        return {};
      }
    }
  }
  std::vector<StudyPower> curve;
  std::transform(sizes.begin(), sizes.end(), std::back_inserter(curve),
                 [](const auto& size) { return size.second; });
  return curve;
}

std::optional<std::size_t> fewest_participants(const std::vector<StudyPower>& curve,
                                               std::optional<std::size_t> comparison,
                                               double power) {
  std::optional<std::size_t> enough;
  for (auto point = curve.rbegin(); point != curve.rend(); ++point) {
    if (share_of_hits(*point, comparison) < power) {
      break;
    }
    enough = point->participants;
  }
  return enough;
}

}  // namespace foveola::analysis
