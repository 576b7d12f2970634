#include "analysis/publication/comparisons.h"

#include <algorithm>
#include <cmath>

#include "analysis/publication/analysis_plan.h"
#include "analysis/publication/participant_values.h"
#include "analysis/statistics/bootstrap.h"
#include "analysis/statistics/multiplicity.h"

namespace foveola::analysis {
namespace {

/// Ranks depend on values' last bits, which are only the rounding errors of means of logarithms and
/// of ratings, so these are rounded off.
std::vector<double> without_rounding(std::vector<double> values) {
  constexpr double step = 1e12;
  for (double& value : values) {
    value = std::round(value * step) / step;
  }
  return values;
}

/// 9999 for studies of the usual size; fewer where thousands of participants would take too long.
int resamples_for(std::size_t participants) {
  constexpr std::size_t most_draws = 20'000'000;
  return static_cast<int>(
      std::clamp<std::size_t>(most_draws / std::max<std::size_t>(participants, 1), 999, 9999));
}

std::optional<Interval> bca_of_ratio(const std::vector<double>& log_ratios) {
  std::vector<double> ratios;
  for (const double value : log_ratios) {
    ratios.push_back(std::exp(value));
  }
  return bca_geometric_mean(ratios, {.resamples = resamples_for(ratios.size())});
}

MethodComparison start_comparison(const AnalysisSet& set, const study::AnalysisPlan& plan,
                                  const std::string& measure, std::size_t method,
                                  std::size_t reference) {
  MethodComparison comparison;
  comparison.measure = measure;
  comparison.method = set.methods[method];
  comparison.reference = set.methods[reference];
  // A comparison is planned whichever of its two methods the plan names first.
  comparison.primary = is_primary(plan, measure, comparison.method, comparison.reference) ||
                       is_primary(plan, measure, comparison.reference, comparison.method);
  comparison.margin = equivalence_margin(plan, measure);
  return comparison;
}

/// `log_times` of `mark`, [participant][method].
MethodComparison compare_times(const AnalysisSet& set, const study::AnalysisPlan& plan, Mark mark,
                               const ParticipantValues& log_times, std::size_t method,
                               std::size_t reference) {
  MethodComparison comparison =
      start_comparison(set, plan, std::string(name_of(mark)), method, reference);
  const std::vector<double> differences = paired_differences(log_times, method, reference);
  comparison.n = differences.size();
  comparison.ratio = ratio_t(differences);
  comparison.ratio_bca = bca_of_ratio(differences);
  comparison.ranks = signed_rank(without_rounding(differences));
  comparison.pseudo_median = pseudo_median(differences);
  if (comparison.margin) {
    comparison.equivalent = equivalence(differences, std::log(*comparison.margin), plan.alpha);
  }
  return comparison;
}

MethodComparison compare_ratings(const AnalysisSet& set, const study::AnalysisPlan& plan,
                                 const ParticipantValues& ratings, std::size_t method,
                                 std::size_t reference) {
  MethodComparison comparison = start_comparison(set, plan, artifacts_measure, method, reference);
  const std::vector<double> differences = paired_differences(ratings, method, reference);
  comparison.n = differences.size();
  comparison.points = one_sample_t(differences);
  comparison.ranks = signed_rank(without_rounding(differences));
  comparison.pseudo_median = pseudo_median(differences);
  if (comparison.margin) {
    comparison.equivalent = equivalence(differences, *comparison.margin, plan.alpha);
  }
  return comparison;
}

/// The P-value that Holm's method adjusts.
std::optional<double> main_p(const MethodComparison& comparison) {
  if (comparison.is_of_ratings()) {
    return comparison.ranks ? std::optional(comparison.ranks->p) : std::nullopt;
  }
  return comparison.ratio ? std::optional(comparison.ratio->logs.p) : std::nullopt;
}

/// Adjusts the P-values of the comparisons for which `belongs` is true.
template <typename Belongs>
void adjust_family(std::vector<MethodComparison>& comparisons, const Belongs& belongs) {
  std::vector<double> p_values;
  std::vector<MethodComparison*> members;
  for (MethodComparison& comparison : comparisons) {
    const std::optional<double> p = main_p(comparison);
    if (belongs(comparison) && p) {
      p_values.push_back(*p);
      members.push_back(&comparison);
    }
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t i = 0; i < members.size(); ++i) {
    members[i]->p_holm = adjusted[i];
  }
}

OmnibusTest test_all(const std::string& measure, const ParticipantValues& values, bool normal) {
  const RepeatedMeasures data = complete_participants(values);
  OmnibusTest test;
  test.measure = measure;
  test.left_out = values.size() - data.participants;
  if (normal) {
    test.variance = repeated_measures_anova(data);
  }
  RepeatedMeasures rounded = data;
  rounded.values = without_rounding(data.values);
  test.ranks = friedman(rounded);
  return test;
}

template <typename Compare>
void compare_pairs(std::size_t methods, const Compare& compare,
                   std::vector<MethodComparison>& comparisons) {
  for (std::size_t reference = 0; reference < methods; ++reference) {
    for (std::size_t method = reference + 1; method < methods; ++method) {
      comparisons.push_back(compare(method, reference));
    }
  }
}

}  // namespace

Comparisons compare_methods(const AnalysisSet& set, const study::AnalysisPlan& plan) {
  Comparisons result;
  result.plan = plan;
  for (const Mark mark : marks) {
    const ParticipantValues log_times = mean_log_times(set, mark);
    compare_pairs(
        set.methods.size(),
        [&](std::size_t method, std::size_t reference) {
          return compare_times(set, plan, mark, log_times, method, reference);
        },
        result.methods);
    result.omnibus.push_back(test_all(std::string(name_of(mark)), log_times, true));
    result.order.push_back({mark, "trial in the session",
                            order_effect(ordered_log_times(set, mark, OrderOf::trials))});
    result.order.push_back({mark, "method in the scene",
                            order_effect(ordered_log_times(set, mark, OrderOf::methods))});
  }
  const ParticipantValues ratings = mean_ratings(set);
  compare_pairs(
      set.methods.size(),
      [&](std::size_t method, std::size_t reference) {
        return compare_ratings(set, plan, ratings, method, reference);
      },
      result.methods);
  result.omnibus.push_back(test_all(artifacts_measure, ratings, false));
  adjust_family(result.methods, [](const MethodComparison& row) { return row.primary; });
  for (const char* measure : {"outline", "material", artifacts_measure}) {
    adjust_family(result.methods, [&](const MethodComparison& row) {
      return !row.primary && row.measure == measure;
    });
  }
  return result;
}

}  // namespace foveola::analysis
