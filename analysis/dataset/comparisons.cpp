#include "analysis/dataset/comparisons.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/statistics/bootstrap.h"
#include "analysis/statistics/correlation.h"
#include "analysis/statistics/models/crossed_model.h"
#include "analysis/statistics/models/order_balance.h"
#include "analysis/statistics/multiplicity.h"
#include "renderer/base/transformed.h"
#include "renderer/base/work/ordered_jobs.h"
#include "renderer/base/work/parallel.h"

namespace foveola::analysis {
namespace {

/// 9999 for studies of ordinary size; fewer for thousands of participants, for speed.
int resamples_for(std::size_t participants) {
  constexpr std::size_t max_draws = 20'000'000;
  return static_cast<int>(
      std::clamp<std::size_t>(max_draws / std::max<std::size_t>(participants, 1), 999, 9999));
}

std::optional<Interval> bca_of_ratio(const std::vector<double>& log_ratios) {
  const std::vector<double> ratios =
      transformed(log_ratios, [&](const double value) { return std::exp(value); });
  return bca_geometric_mean(ratios, {.resamples = resamples_for(ratios.size())});
}

MethodComparison start_comparison(const Dataset& set, const study::AnalysisPlan& plan,
                                  std::size_t measure, std::size_t method, std::size_t reference) {
  MethodComparison comparison;
  comparison.measure = set.measures[measure].id();
  comparison.is_time = set.measures[measure].is_time();
  comparison.method = set.methods[method];
  comparison.reference = set.methods[reference];
  if (const auto margin = plan.equivalence_margins.find(comparison.measure);
      margin != plan.equivalence_margins.end()) {
    comparison.margin = margin->second;
  }
  return comparison;
}

std::string why_no_p(const MethodComparison& comparison) {
  if (comparison.primary) {
    return "";
  }
  return comparison.n < 2 ? fmt::format("{} with both values: a test needs two",
                                        comparison.n == 1 ? "one participant" : "no participant")
                          : "the differences do not vary";
}

CompleteCases complete_cases(const ParticipantValues& means, const ComparedPair& pair,
                             bool is_time) {
  const std::vector<double> differences = paired_differences(means, pair.method, pair.reference);
  CompleteCases cases{.n = differences.size()};
  if (is_time) {
    cases.ratio = test_ratio(differences);
  } else {
    cases.points = test_mean(differences);
  }
  return cases;
}

/// Does nothing for a single difference, which has neither ranks nor pairs.
void compare_ranks(const std::vector<double>& differences, MethodComparison& comparison) {
  if (differences.size() < 2) {
    return;
  }
  comparison.ranks = signed_rank(without_rounding(differences));
  comparison.pseudo_median = pseudo_median(differences);
}

std::optional<PrimaryResult> primary_of(const MethodComparison& comparison,
                                        const PairedTrials& trials, const study::AnalysisPlan& plan,
                                        bool has_points, const FittedModels& models) {
  if (comparison.n < 2) {
    return std::nullopt;
  }
  const auto model = [&](const char* name) {
    return models.find(name, comparison.measure, comparison.method, comparison.reference);
  };
  const PrimarySources sources{.pairs = trials,
                               .t = comparison.t_test(),
                               .ranks = comparison.ranks,
                               .pseudo_median = comparison.pseudo_median,
                               .crossed = model("crossed"),
                               .tobit = model("tobit"),
                               .ordinal = model("ordinal")};
  return comparison.is_time ? primary_of_times(sources, plan)
                            : primary_of_ratings(sources, plan, has_points);
}

/// Returns why the primary analysis has no test of equivalence; empty if it has one.
std::string why_no_equivalence(const MethodComparison& comparison) {
  if (!comparison.primary) {
    return comparison.missing;
  }
  if (comparison.primary->omits_censored) {
    return "with right-censored times it needs the Tobit model: " + comparison.primary->instead;
  }
  return comparison.primary->kind == AnalysisKind::ordinal_model
             ? "a margin in points does not apply to the odds ratio, which the cumulative link "
               "mixed "
               "model estimates; plan ratings = \"signed_ranks\""
             : "";
}

/// Tests equivalence by the primary analysis, or not at all. `differences`: the participants'
/// means.
void add_equivalence(const std::vector<double>& differences, double alpha,
                     MethodComparison& comparison) {
  if (!comparison.margin) {
    return;
  }
  comparison.no_equivalence = why_no_equivalence(comparison);
  if (!comparison.no_equivalence.empty()) {
    return;
  }
  const PrimaryResult& primary = *comparison.primary;
  const double margin = comparison.is_time ? std::log(*comparison.margin) : *comparison.margin;
  comparison.equivalent = primary.kind == AnalysisKind::signed_ranks
                              ? test_equivalence_by_ranks(differences, margin, alpha)
                              : test_equivalence(primary.estimate, primary.standard_error.value(),
                                                 primary.degrees_of_freedom.value(), margin, alpha);
}

/// The participants of a primary analysis without R, and their mean differences.
struct Analysed {
  std::vector<std::size_t> who;
  std::vector<double> means;
};

/// The crossed model in closed form uses participants with all scenes only.
Analysed analysed_by(AnalysisKind kind, const PairedTrials& trials) {
  const std::vector<double> means = trials.participant_means();
  Analysed analysed;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const auto& row = trials.differences[i];
    if (kind != AnalysisKind::crossed_model ||
        std::ranges::all_of(row, [](const auto& value) { return value.has_value(); })) {
      analysed.who.push_back(trials.who[i]);
      analysed.means.push_back(means[i]);
    }
  }
  return analysed;
}

void measure_influence(const Dataset& set, const PairedTrials& trials,
                       MethodComparison& comparison) {
  constexpr std::size_t fewest = 3;
  constexpr std::size_t most = 2000;  // time grows with the square
  if (!comparison.primary) {
    comparison.no_influence = comparison.missing;
    return;
  }
  const PrimaryResult& primary = *comparison.primary;
  if (primary.is_by_r) {
    comparison.influence = primary.influence_by_r;
    comparison.no_influence =
        comparison.influence
            ? ""
            : fmt::format("the {} was not fitted without each", name_of(primary.kind));
    return;
  }
  const Analysed analysed = analysed_by(primary.kind, trials);
  if (analysed.who.size() < fewest || analysed.who.size() > most) {
    comparison.no_influence = fmt::format("{} participants", analysed.who.size());
    return;
  }
  // The crossed model's estimate is the mean, whatever the variances.
  const LeaveOneOut range = leave_one_out(analysed.means, [&](std::span<const double> others) {
                              return primary.kind == AnalysisKind::signed_ranks
                                         ? pseudo_median(others)->value
                                         : *mean(others);
                            }).value();
  comparison.influence =
      Influence{range.estimates, set.participants[analysed.who[range.without_low]],
                set.participants[analysed.who[range.without_high]]};
}

MethodComparison compare_primarily(const Dataset& set, const study::AnalysisPlan& plan,
                                   const ComparedPair& pair, const PairedTrials& trials,
                                   const FittedModels& models) {
  MethodComparison comparison =
      start_comparison(set, plan, pair.measure, pair.method, pair.reference);
  comparison.n = trials.participants();
  comparison.pairs = trials.pairs;
  comparison.censored = trials.censored;
  const std::vector<double> differences = trials.participant_means();
  comparison.mean = mean(differences);
  if (comparison.is_time) {
    comparison.ratio = test_ratio(differences);
  } else {
    comparison.points = test_mean(differences);
    compare_ranks(differences, comparison);
  }
  comparison.primary =
      primary_of(comparison, trials, plan, !set.measures[pair.measure].points().empty(), models);
  comparison.missing = why_no_p(comparison);
  add_equivalence(differences, plan.alpha, comparison);
  return comparison;
}

/// `means`: of this measure, by participant_means.
MethodComparison compare(const Dataset& set, const study::AnalysisPlan& plan,
                         const ComparedPair& pair, const ParticipantValues& means,
                         const FittedModels& models) {
  const PairedTrials trials = paired_trials(set, pair.measure, pair.method, pair.reference);
  MethodComparison comparison = compare_primarily(set, plan, pair, trials, models);
  if (comparison.is_time) {
    const std::vector<double> differences = trials.participant_means();
    comparison.ratio_bca = bca_of_ratio(differences);
    compare_ranks(differences, comparison);
  }
  comparison.complete = complete_cases(means, pair, comparison.is_time);
  measure_influence(set, trials, comparison);
  return comparison;
}

std::vector<MethodComparison> compare_all(const Dataset& set, const study::AnalysisPlan& plan,
                                          const std::vector<ParticipantValues>& means,
                                          const FittedModels& models) {
  const std::vector<ComparedPair> pairs = compared_pairs(set, plan);
  std::vector<MethodComparison> compared;
  OrderedJobs<MethodComparison> jobs(pairs.size(), pairs.size(), [&](std::size_t index) {
    return compare(set, plan, pairs[index], means[pairs[index].measure], models);
  });
  jobs.run(usable_cores(), [&](std::size_t /*index*/, MethodComparison comparison) {
    compared.push_back(std::move(comparison));
    return true;
  });
  return compared;
}

/// Adjusts the P-values of a family. A missing P-value counts as not significant: a family is never
/// smaller than planned.
template <typename P>
void adjust_family(const std::vector<MethodComparison*>& family, const P& p_of,
                   std::optional<double> MethodComparison::* adjusted_p) {
  const std::vector<double> p_values = transformed(
      family, [&](const MethodComparison* member) { return p_of(*member).value_or(1.0); });
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < family.size(); ++i) {
    if (p_of(*family[i])) {
      family[i]->*adjusted_p = adjusted[i];
    }
  }
}

/// The primary analyses are a family, and so are the tests of equivalence with a margin.
void adjust_families(std::vector<MethodComparison>& planned) {
  std::vector<MethodComparison*> all;
  std::vector<MethodComparison*> with_margin;
  for (MethodComparison& comparison : planned) {
    all.push_back(&comparison);
    if (comparison.margin) {
      with_margin.push_back(&comparison);
    }
  }
  adjust_family(
      all, [](const auto& of) { return of.primary ? std::optional(of.primary->p) : std::nullopt; },
      &MethodComparison::p_holm);
  adjust_family(
      with_margin,
      [](const auto& of) { return of.equivalent ? std::optional(of.equivalent->p) : std::nullopt; },
      &MethodComparison::p_equivalent_holm);
}

OmnibusTest test_all(const Dataset& set, std::size_t index, const ParticipantValues& values) {
  const RepeatedMeasures data = complete_participants(values);
  const Measure& measure = set.measures[index];
  OmnibusTest test;
  test.measure = measure.id();
  test.censored = set.censored(index);
  test.left_out = values.size() - data.participants;
  if (measure.is_time()) {
    test.variance = repeated_measures_anova(data);
  }
  RepeatedMeasures rounded = data;
  rounded.values = without_rounding(data.values);
  test.ranks = friedman(rounded);
  return test;
}

/// Carry-over: the change of each method's values right after each other one, against those after
/// the rest. None unless every method follows every other, and there are at least three. With three
/// methods, a method's second change is the negative of the first.
std::vector<OrderTest> carry_over_tests(const Dataset& set, std::size_t measure) {
  const std::size_t methods = set.methods.size();
  std::vector<OrderTest> tests;
  for (std::size_t method = 0; methods > 2 && method < methods; ++method) {
    bool is_known = false;
    for (std::size_t previous = 0; previous < methods; ++previous) {
      if (previous == method) {
        continue;
      }
      const std::vector<OrderedValue> values = values_by_previous(set, measure, method, previous);
      if (std::ranges::none_of(values,
                               [](const OrderedValue& value) { return value.position > 0.0; })) {
        return {};
      }
      if (methods > 3 || !is_known) {
        tests.push_back({set.measures[measure].id(), set.measures[measure].is_time(),
                         fmt::format("{} after {}", set.methods[method], set.methods[previous]),
                         set.censored(measure), order_effect(values)});
      }
      is_known = true;
    }
  }
  return tests;
}

std::vector<ParticipantValues> means_of_measures(const Dataset& set) {
  std::vector<ParticipantValues> means(set.measures.size());
  for (std::size_t measure = 0; measure < means.size(); ++measure) {
    if (set.measures[measure].is_numeric()) {
      means[measure] = participant_means(set, measure);
    }
  }
  return means;
}

/// Calls compare_pair(pair) for each planned comparison, and adjusts all P-values together.
template <typename Compare>
std::vector<MethodComparison> planned_comparisons(const Dataset& set,
                                                  const study::AnalysisPlan& plan,
                                                  const Compare& compare_pair) {
  std::vector<MethodComparison> comparisons;
  for (const study::PlannedComparison& planned : plan.primary) {
    if (const std::optional<ComparedPair> pair = pair_of(set, planned)) {
      comparisons.push_back(compare_pair(*pair));
    } else {
      comparisons.push_back({.measure = planned.measure,
                             .method = planned.method,
                             .reference = planned.baseline,
                             .missing = "the study has no such measure or method"});
    }
    comparisons.back().planned = true;
  }
  adjust_families(comparisons);
  return comparisons;
}

}  // namespace

std::vector<MethodComparison> planned_primary_analyses(const Dataset& set,
                                                       const study::AnalysisPlan& plan,
                                                       const FittedModels& models) {
  return planned_comparisons(set, plan, [&](const ComparedPair& pair) {
    return compare_primarily(set, plan, pair,
                             paired_trials(set, pair.measure, pair.method, pair.reference), models);
  });
}

Comparisons compare_methods(const Dataset& set, const study::AnalysisPlan& plan,
                            FittedModels models) {
  const std::vector<ParticipantValues> means = means_of_measures(set);
  std::vector<MethodComparison> compared = compare_all(set, plan, means, models);
  auto next = std::make_move_iterator(compared.begin());
  Comparisons result;
  result.plan = plan;
  result.methods =
      planned_comparisons(set, plan, [&](const ComparedPair& /*pair*/) { return *next++; });
  result.methods.insert(result.methods.end(), next, std::make_move_iterator(compared.end()));
  for (std::size_t measure = 0; measure < set.measures.size(); ++measure) {
    const Measure& of = set.measures[measure];
    if (!of.is_numeric()) {
      continue;
    }
    result.omnibus.push_back(test_all(set, measure, means[measure]));
    for (const auto& [order, name] : {std::pair(OrderOf::trials, "trial in the session"),
                                      std::pair(OrderOf::methods, "method in the scene")}) {
      result.order.push_back({of.id(), of.is_time(), name, set.censored(measure),
                              order_effect(ordered_values(set, measure, order))});
    }
    for (OrderTest& test : carry_over_tests(set, measure)) {
      result.order.push_back(std::move(test));
    }
  }
  result.models = std::move(models);
  result.censored_times = censored_times_in_words(set);
  return result;
}

}  // namespace foveola::analysis
