#include "analysis/monte_carlo/coverage.h"

#include <cassert>
#include <cmath>
#include <string_view>
#include <utility>

#include "analysis/dataset/comparisons.h"
#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/study_tables.h"
#include "analysis/monte_carlo/censored_coverage.h"
#include "analysis/monte_carlo/expected_study.h"
#include "analysis/statistics/bootstrap.h"
#include "analysis/statistics/distributions.h"
#include "analysis/statistics/paired_t.h"
#include "analysis/statistics/rank_tests.h"
#include "analysis/statistics/repeated_measures.h"

namespace foveola::analysis {
namespace {

// Indices of the measures of studies with injected effects.
constexpr std::size_t outline = 0;
constexpr std::size_t material = 1;
constexpr std::size_t recognition = 2;
constexpr std::size_t comfort = 4;

constexpr Interval nominal_coverage = {93.5, 96.5};
constexpr Interval nominal_rejection = {4.0, 6.0};

/// Whether the criterion holds in one study; empty if it has no such interval or test.
using Outcome = std::optional<bool>;

Outcome covers(const std::optional<Interval>& interval, double value) {
  return interval ? Outcome(interval->low <= value && value <= interval->high) : std::nullopt;
}

Outcome covers_percent(const StudyTables& tables, std::size_t mark, std::size_t method,
                       double ratio) {
  const auto& estimate = tables.method_times_of(mark, method).percent_of_baseline;
  return estimate ? covers(estimate->interval, 100.0 * ratio) : std::nullopt;
}

/// Returns the logarithms of all participants' ratios of the last method to the baseline.
std::vector<double> log_ratios(const Dataset& set) {
  return paired_differences(participant_means(set, outline), set.methods.size() - 1, baseline);
}

std::vector<double> comfort_differences(const Dataset& set) {
  return paired_differences(participant_means(set, comfort), set.methods.size() - 1, baseline);
}

/// A property of intervals or tests, and the share of studies in which it must hold.
struct Criterion {
  std::string_view name;
  std::string_view claim;
  std::optional<Interval> required;
  ExpectedStudy expected;
  std::function<Outcome(const Dataset&, const StudyTables&)> holds;
};

std::vector<Criterion> criteria_with_effects(const CoverageSettings& settings) {
  const ExpectedStudy effects = example_study();
  const std::vector<double>& ratios = effects.times[outline].ratios;
  ExpectedStudy learning = effects;
  learning.change_per_trial = -0.02;
  std::vector<Criterion> criteria;
  for (const std::size_t mark : {outline, material}) {
    for (const std::size_t method : {std::size_t{1}, std::size_t{2}}) {
      const double ratio = ratios[method];
      const std::string_view name =
          mark == outline
              ? (method == 1 ? "t interval, VP 32 %, outline" : "t interval, FV 10 %, outline")
              : (method == 1 ? "t interval, VP 32 %, material" : "t interval, FV 10 %, material");
      criteria.push_back({name, "covers the injected ratio", nominal_coverage, effects,
                          [=](const Dataset&, const StudyTables& tables) {
                            return covers_percent(tables, mark, method, ratio);
                          }});
    }
  }
  criteria.push_back({"BCa interval, FV 10 %, outline", "covers the injected ratio", std::nullopt,
                      effects, [=](const Dataset&, const StudyTables& tables) {
                        const MethodTimes& times = tables.method_times_of(outline, 2);
                        return covers(bca_geometric_mean(times.participant_percent,
                                                         {.resamples = settings.resamples}),
                                      100.0 * ratios[2]);
                      }});
  criteria.push_back({"pseudo-median's interval, FV 10 %, outline", "covers the injected ratio",
                      std::nullopt, effects, [=](const Dataset& set, const StudyTables&) {
                        const auto found = pseudo_median(log_ratios(set));
                        return found && found->interval
                                   ? covers(found->interval, std::log(ratios[2]))
                                   : std::nullopt;
                      }});
  criteria.push_back(
      {"t interval, learning 2 % per trial", "covers the injected change", nominal_coverage,
       learning, [=](const Dataset& set, const StudyTables&) {
         const auto found = order_effect(ordered_values(set, outline, OrderOf::trials));
         return found ? covers(found->interval, learning.change_per_trial) : std::nullopt;
       }});
  return criteria;
}

Outcome below(std::optional<double> p) { return p ? Outcome(*p < 0.05) : std::nullopt; }

template <typename Test>
std::optional<double> p_of(const std::optional<Test>& test) {
  return test ? std::optional(test->p) : std::nullopt;
}

std::vector<Criterion> criteria_without_effect() {
  ExpectedStudy null = example_study();
  for (ExpectedTimes& times : null.times) {
    times.ratios = {1.0, 1.0, 1.0};
  }
  const auto measures = [](const Dataset& set) {
    return complete_participants(participant_means(set, outline));
  };
  return {{"paired t on logs, no effect", "rejects at 5 %", nominal_rejection, null,
           [](const Dataset& set, const StudyTables&) {
             return below(p_of(test_mean(log_ratios(set))));
           }},
          {"Wilcoxon signed-rank, no effect", "rejects at 5 %", std::nullopt, null,
           [](const Dataset& set, const StudyTables&) {
             return below(p_of(signed_rank(log_ratios(set))));
           }},
          {"ANOVA, Greenhouse-Geisser, no effect", "rejects at 5 %", std::nullopt, null,
           [=](const Dataset& set, const StudyTables&) {
             const auto test = repeated_measures_anova(measures(set));
             return test ? below(test->p_greenhouse_geisser) : std::nullopt;
           }},
          {"ANOVA, Huynh-Feldt, no effect", "rejects at 5 %", std::nullopt, null,
           [=](const Dataset& set, const StudyTables&) {
             const auto test = repeated_measures_anova(measures(set));
             return test ? below(test->p_huynh_feldt) : std::nullopt;
           }},
          {"Friedman, no effect", "rejects at 5 %", std::nullopt, null,
           [=](const Dataset& set, const StudyTables&) {
             return below(p_of(friedman(measures(set))));
           }}};
}

/// Compares fv and od in `outline`, whose ratio is at the margin. Without R there is no model of
/// right-censored times, and so no test.
std::vector<Criterion> criteria_of_equivalence() {
  constexpr Interval no_more_than_chance = {0.0, 6.8};
  constexpr double margin = 1.25;
  std::vector<Criterion> criteria;
  for (const auto& [name, censored] :
       {std::pair("equivalence within 25 %, ratio at the margin", 0.0),
        std::pair("the same, 20 % of OD's times right-censored", 0.2),
        std::pair("the same, 40 % of OD's times right-censored", 0.4)}) {
    const ExpectedStudy expected = gain_study({.participants_gain = 0.15,
                                               .censored = censored,
                                               .scenes = study::SceneEffects::fixed,
                                               .ratio = 1.0 / margin,
                                               .margin = margin});
    criteria.push_back(
        {name, "wrongly declared at 5 %", no_more_than_chance, expected,
         [plan = expected.protocol.analysis](const Dataset& set, const StudyTables&) -> Outcome {
           const auto test = planned_primary_analyses(set, plan).front().equivalent;
           return test && test->p < plan.alpha;
         }});
  }
  return criteria;
}

std::vector<Criterion> criteria_of_other_measures() {
  constexpr double shift_points = 5.0;
  const ExpectedStudy effects = example_study();
  const double ratio = effects.times[recognition].ratios.back();
  ExpectedStudy comfortable = effects;
  comfortable.shifts.back().back() = shift_points;
  return {
      {"t interval, FV 10 %, a third mark", "covers the injected ratio", nominal_coverage, effects,
       [=](const Dataset&, const StudyTables& tables) {
         return covers_percent(tables, recognition, 2, ratio);
       }},
      {"t interval, 5 points in a rating of 0 to 100", "covers the injected change",
       nominal_coverage, comfortable,
       [=](const Dataset& set, const StudyTables&) {
         const auto found = test_mean(comfort_differences(set));
         return found ? covers(found->interval, shift_points) : std::nullopt;
       }},
      {"paired t, a rating of 0 to 100, no effect", "rejects at 5 %", nominal_rejection, effects,
       [](const Dataset& set, const StudyTables&) {
         return below(p_of(test_mean(comfort_differences(set))));
       }}};
}

std::vector<Criterion> all_criteria(const CoverageSettings& settings) {
  std::vector<Criterion> criteria = criteria_with_effects(settings);
  for (const std::vector<Criterion>& more :
       {criteria_without_effect(), criteria_of_equivalence(), criteria_of_other_measures()}) {
    criteria.insert(criteria.end(), more.begin(), more.end());
  }
  return criteria;
}

/// Each study is seeded by its number, independently of its thread.
StudyCount count(const Criterion& criterion, const CoverageSettings& settings, std::uint64_t stream,
                 std::size_t first, std::size_t last) {
  StudyCount counts;
  for (std::size_t study = first; study < last; ++study) {
    const std::uint64_t seed = (settings.seed << 40U) + (stream << 32U) + study;
    const StudyTables tables = tabulate_study(
        draw_study(criterion.expected, static_cast<std::size_t>(settings.participants), seed));
    counts.add(criterion.holds(tables.set, tables));
  }
  return counts;
}

}  // namespace

CoverageFigure measured(CoverageFigure figure, const StudyCount& count) {
  figure.studies = count.studies;
  figure.hits = count.hits;
  if (count.studies > 0) {
    figure.percent = 100.0 * static_cast<double>(count.hits) / static_cast<double>(count.studies);
    const Interval share = clopper_pearson(count.hits, count.studies);
    figure.interval = {100.0 * share.low, 100.0 * share.high};
    if (figure.estimates_ratios) {
      figure.mean_ratio = count.mean_ratio();
    }
  }
  return figure;
}

std::vector<CoverageFigure> measure_injected_coverage(
    const CoverageSettings& settings, const std::function<void(double)>& on_progress,
    const std::stop_token& stop) {
  constexpr std::size_t studies_at_once = 50;
  const std::vector<Criterion> criteria = all_criteria(settings);
  const Workers workers(settings.threads);
  std::vector<CoverageFigure> figures;
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    if (stop.stop_requested()) {
      return {};
    }
    const auto count_block = [&](std::size_t first, std::size_t last) -> StudyCounts {
      return {count(criteria[i], settings, i, first, last)};
    };
    figures.push_back(measured(
        {.name = std::string(criteria[i].name),
         .claim = std::string(criteria[i].claim),
         .required = criteria[i].required},
        sum_of_blocks(1, settings.studies, studies_at_once, workers, count_block).front()));
    on_progress(static_cast<double>(i + 1) / static_cast<double>(criteria.size()));
  }
  return figures;
}

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
