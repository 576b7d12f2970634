#include "analysis/publication/comparison_tables.h"

#include <cmath>
#include <functional>
#include <string>

#include "analysis/publication/result_tables.h"

namespace foveola::analysis {
namespace {

using enum ColumnType;

/// Adds a number of a result that may not exist, times `scale`.
template <typename Item, typename Result>
void add_number(const std::string& name, const std::string& unit, const std::string& description,
                const std::function<std::optional<Result>(const Item&)>& result,
                const std::function<double(const Result&)>& value, ColumnsOf<Item>& columns) {
  columns.push_back({{name, number, unit, description},
                     [=](const Item& row) { return field_in(result(row), value); }});
}

void add_ratio(ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, RatioTest>(
        name, "%", description, [](const MethodComparison& row) { return row.ratio; }, value,
        columns);
  };
  columns.push_back({{"ratio_percent", number, "%",
                      "Of times: geometric mean of the participants' ratios, method to reference"},
                     [](const MethodComparison& row) {
                       return row.is_time && row.mean ? field(100.0 * row.in_unit(*row.mean))
                                                      : Field();
                     }});
  add("ci95_low_percent", "Lower end of its 95 % t interval",
      [](const RatioTest& test) { return 100.0 * test.interval.low; });
  add("ci95_high_percent", "Upper end of its 95 % t interval",
      [](const RatioTest& test) { return 100.0 * test.interval.high; });
  const auto add_bca = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, Interval>(
        name, "%", description, [](const MethodComparison& row) { return row.ratio_bca; }, value,
        columns);
  };
  add_bca("bca95_low_percent", "Lower end of its 95 % bootstrap interval (BCa)",
          [](const Interval& bca) { return 100.0 * bca.low; });
  add_bca("bca95_high_percent", "Upper end of its 95 % bootstrap interval (BCa)",
          [](const Interval& bca) { return 100.0 * bca.high; });
}

void add_points(ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, TTest>(
        name, "points", description, [](const MethodComparison& row) { return row.points; }, value,
        columns);
  };
  columns.push_back(
      {{"difference_points", number, "points",
        "Of ratings: mean difference, method less reference"},
       [](const MethodComparison& row) { return row.is_time ? Field() : field(row.mean); }});
  add("ci95_low_points", "Lower end of its 95 % t interval",
      [](const TTest& test) { return test.interval.low; });
  add("ci95_high_points", "Upper end of its 95 % t interval",
      [](const TTest& test) { return test.interval.high; });
}

void add_t(ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, TTest>(
        name, "", description,
        [](const MethodComparison& row) {
          return row.ratio ? std::optional(row.ratio->logs) : row.points;
        },
        value, columns);
  };
  add("t", "Paired t, of log ratios of times or differences of ratings",
      [](const TTest& test) { return test.t; });
  add("df", "Degrees of freedom of t", [](const TTest& test) { return test.degrees_of_freedom; });
  add("p_t", "Two-sided P of t", [](const TTest& test) { return test.p; });
  add("d_z", "Effect size: mean over standard deviation of the differences",
      [](const TTest& test) { return test.d_z; });
}

void add_ranks(ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, SignedRankTest>(
        name, "", description, [](const MethodComparison& row) { return row.ranks; }, value,
        columns);
  };
  add("w_plus", "Wilcoxon's sum of ranks of positive differences",
      [](const SignedRankTest& test) { return test.w_plus; });
  add("w_minus", "Wilcoxon's sum of ranks of negative differences",
      [](const SignedRankTest& test) { return test.w_minus; });
  columns.push_back({{"zeros", whole, "", "Differences of zero, which are left out of the ranks"},
                     [](const MethodComparison& row) {
                       return field_in(row.ranks, [](auto& test) { return test.zeros; });
                     }});
  add("p_wilcoxon", "Two-sided P of the signed-rank test",
      [](const SignedRankTest& test) { return test.p; });
  columns.push_back(
      {{"wilcoxon_exact", truth, "", "Whether that P is exact"}, [](const MethodComparison& row) {
         return field_in(row.ranks, [](auto& test) { return test.exact; });
       }});
  add("rank_biserial", "Effect size: matched-pairs rank-biserial correlation",
      [](const SignedRankTest& test) { return test.rank_biserial; });
}

/// Adds Hodges and Lehmann's estimate for times or for ratings: three columns in one unit.
void add_pseudo_median(bool of_times, const std::string& name_unit, const std::string& unit,
                       double scale, ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const std::string& name, const char* description, auto value) {
    columns.push_back(
        {{name + name_unit, number, unit, description}, [=](const MethodComparison& row) {
           const std::optional<double> tested = row.is_time == of_times && row.pseudo_median
                                                    ? value(*row.pseudo_median)
                                                    : std::nullopt;
           return tested ? field(scale * row.in_unit(*tested)) : Field();
         }});
  };
  using Number = std::optional<double>;
  add("pseudo_median_", "Hodges and Lehmann's estimate",
      [](const PseudoMedian& found) { return Number(found.value); });
  add("pseudo_median_low_", "Lower end of its 95 % interval", [](const PseudoMedian& found) {
    return found.interval ? Number(found.interval->low) : std::nullopt;
  });
  add("pseudo_median_high_", "Upper end of its 95 % interval", [](const PseudoMedian& found) {
    return found.interval ? Number(found.interval->high) : std::nullopt;
  });
}

void add_equivalence(double alpha, ColumnsOf<MethodComparison>& columns) {
  const auto add = [&](const char* name, const char* description, auto value) {
    columns.push_back({{name, number, "", description}, [=](const MethodComparison& row) {
                         return field_in(row.equivalent, [&](const EquivalenceTest& test) {
                           return value(row, test);
                         });
                       }});
  };
  columns.push_back(
      {{"equivalence_margin", number, "", "Planned margin: a factor of times, or points"},
       [](const MethodComparison& row) { return field(row.margin); }});
  add("equivalence_confidence_percent",
      "Confidence of the interval that follows, 1 − 2 alpha: it lies within the margins where the "
      "unadjusted P is below alpha",
      [=](const auto& /*row*/, const auto& /*test*/) { return 100.0 * (1.0 - 2.0 * alpha); });
  const auto add_end = [&](const char* name, const char* description, double Interval::* end) {
    add(name, description, [=](const MethodComparison& row, const EquivalenceTest& test) {
      return test.interval ? std::optional(row.in_unit(*test.interval.*end)) : std::nullopt;
    });
  };
  add_end("equivalence_interval_low", "Lower end of that interval, in the margin's unit",
          &Interval::low);
  add_end("equivalence_interval_high", "Its upper end", &Interval::high);
  add("p_above_low_margin", "One-sided P that the difference lies above the lower margin",
      [](const auto& /*row*/, const auto& test) { return test.p_above_low; });
  add("p_below_high_margin", "One-sided P that it lies below the upper margin",
      [](const auto& /*row*/, const auto& test) { return test.p_below_high; });
  add("p_equivalence", "The larger of the two",
      [](const auto& /*row*/, const auto& test) { return test.p; });
  columns.push_back(
      {{"p_equivalence_holm", number, "",
        "That P adjusted by Holm's method over the planned comparisons with a margin, a family of "
        "their own; empty for exploratory ones, which are not adjusted"},
       [](const MethodComparison& row) { return field(row.p_equivalent_holm); }});
  columns.push_back({{"equivalence_note", text, "",
                      "Why a comparison with a margin has no test of equivalence; empty if it has"},
                     [](const MethodComparison& row) { return field(row.no_equivalence); }});
}

void add_primary(ColumnsOf<MethodComparison>& columns) {
  const auto add_text = [&](const char* name, const char* description, auto value) {
    columns.push_back({{name, text, "", description}, [=](const MethodComparison& row) {
                         return row.primary ? field(std::string(value(*row.primary))) : Field();
                       }});
  };
  const auto add = [&](const char* name, const char* description, auto value) {
    columns.push_back({{name, number, "", description}, [=](const MethodComparison& row) {
                         return row.primary ? field(std::optional<double>(value(*row.primary)))
                                            : Field();
                       }});
  };
  add_text("analysis", "The primary analysis",
           [](const PrimaryResult& result) { return name_of(result.kind); });
  add_text("analysis_note",
           "Why it stands in for the one that was planned; empty if it is that one",
           [](const PrimaryResult& result) { return result.instead; });
  add_text("analysis_warning", "What R warned of it",
           [](const PrimaryResult& result) { return result.warning; });
  add_text("scale", "What its estimate is: ratio, odds ratio or points",
           [](const PrimaryResult& result) { return name_of(result.scale); });
  columns.push_back(
      {{"scenes", whole, "", "Scenes that its estimate rests on"}, [](const MethodComparison& row) {
         return field_in(row.primary, [](auto& result) { return result.scenes; });
       }});
  add("estimate", "Estimate of the primary analysis",
      [](const PrimaryResult& result) { return in_scale(result.scale, result.estimate); });
  const auto end = [](const PrimaryResult& result, double Interval::* which) {
    return result.interval ? std::optional(in_scale(result.scale, *result.interval.*which))
                           : std::nullopt;
  };
  add("estimate_low", "Lower end of its 95 % interval",
      [=](const PrimaryResult& result) { return end(result, &Interval::low); });
  add("estimate_high", "Upper end of its 95 % interval",
      [=](const PrimaryResult& result) { return end(result, &Interval::high); });
  add("estimate_df", "Its degrees of freedom, where it has any",
      [](const PrimaryResult& result) { return result.degrees_of_freedom; });
  add("p", "Its two-sided P", [](const PrimaryResult& result) { return result.p; });
  columns.push_back(
      {{"p_holm", number, "",
        "P adjusted by Holm's method over all planned comparisons together; empty for "
        "exploratory ones, which are not adjusted"},
       [](const MethodComparison& row) { return field(row.p_holm); }});
  columns.push_back({{"missing", text, "", "Why there is no P; empty if there is one"},
                     [](const MethodComparison& row) { return field(row.missing); }});
}

void add_influence(ColumnsOf<MethodComparison>& columns) {
  const auto add_number = [&](const char* name, const char* description, auto value) {
    columns.push_back({{name, number, "", description}, [=](const MethodComparison& row) {
                         return field_in(row.influence, [&](const Influence& found) {
                           return row.in_unit(value(found.estimates));
                         });
                       }});
  };
  const auto add_code = [&](const char* name, const char* description, auto value) {
    columns.push_back({{name, text, "", description}, [=](const MethodComparison& row) {
                         return field_in(row.influence, value);
                       }});
  };
  add_number("leave_one_out_low",
             "Smallest primary estimate without one participant, as a ratio or in points",
             [](const Interval& estimates) { return estimates.low; });
  add_code("leave_one_out_low_without", "The code of that participant",
           [](const Influence& found) { return found.without_low; });
  add_number("leave_one_out_high", "Largest estimate without one participant",
             [](const Interval& estimates) { return estimates.high; });
  add_code("leave_one_out_high_without", "The code of that participant",
           [](const Influence& found) { return found.without_high; });
  columns.push_back({{"leave_one_out_note", text, "", "Why there is none; empty if there is"},
                     [](const MethodComparison& row) { return field(row.no_influence); }});
}

void add_complete_cases(ColumnsOf<MethodComparison>& columns) {
  columns.push_back({{"n_complete", whole, "",
                      "Participants with a scene in which all methods were measured (complete "
                      "cases)"},
                     [](const MethodComparison& row) { return field(row.complete.n); }});
  const auto add_ratio = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, RatioTest>(
        name, "%", description, [](const MethodComparison& row) { return row.complete.ratio; },
        value, columns);
  };
  add_ratio("complete_ratio_percent", "Of times, in those scenes: ratio_percent",
            [](const RatioTest& test) { return 100.0 * test.ratio; });
  add_ratio("complete_ci95_low_percent", "Lower end of its 95 % t interval",
            [](const RatioTest& test) { return 100.0 * test.interval.low; });
  add_ratio("complete_ci95_high_percent", "Upper end of its 95 % t interval",
            [](const RatioTest& test) { return 100.0 * test.interval.high; });
  const auto add_points = [&](const char* name, const char* description, auto value) {
    add_number<MethodComparison, TTest>(
        name, "points", description,
        [](const MethodComparison& row) { return row.complete.points; }, value, columns);
  };
  add_points("complete_difference_points", "Of ratings, in those scenes: difference_points",
             [](const TTest& test) { return test.mean; });
  add_points("complete_ci95_low_points", "Lower end of its 95 % t interval",
             [](const TTest& test) { return test.interval.low; });
  add_points("complete_ci95_high_points", "Upper end of its 95 % t interval",
             [](const TTest& test) { return test.interval.high; });
}

template <typename Value>
ColumnOf<OmnibusTest> of_variance(const char* name, const char* description, Value value) {
  return {{name, number, "", description},
          [=](const OmnibusTest& row) { return field_in(row.variance, value); }};
}

template <typename Value>
ColumnOf<OmnibusTest> of_ranks(const char* name, const char* description, Value value) {
  return {{name, number, "", description},
          [=](const OmnibusTest& row) { return field_in(row.ranks, value); }};
}

}  // namespace

Table comparisons_table(const StudyTables& tables, const Comparisons& comparisons) {
  ColumnsOf<MethodComparison> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [](const MethodComparison& row) { return field(row.measure); }},
      {{"method", text, "", "Id of the method"},
       [](const MethodComparison& row) { return field(row.method); }},
      {{"reference", text, "", "Id of the method that it is compared with"},
       [](const MethodComparison& row) { return field(row.reference); }},
      {{"status", text, "", "planned in the protocol, or exploratory"},
       [](const MethodComparison& row) {
         return field(std::string(row.planned ? "planned" : "exploratory"));
       }},
      {{"n", whole, "", "Participants with a pair of trials"},
       [](const MethodComparison& row) { return field(row.n); }},
      {{"pairs", whole, "", "Pairs of trials with both values, of a participant in a scene"},
       [](const MethodComparison& row) { return field(row.pairs); }},
      {{"censored_pairs", whole, "", "Pairs with a right-censored time, which are not among these"},
       [](const MethodComparison& row) { return field(row.censored); }}};
  add_primary(columns);
  add_ratio(columns);
  add_points(columns);
  add_t(columns);
  add_ranks(columns);
  add_pseudo_median(true, "ratio_percent", "%", 100.0, columns);
  add_pseudo_median(false, "points", "points", 1.0, columns);
  add_equivalence(comparisons.plan.alpha, columns);
  add_complete_cases(columns);
  add_influence(columns);
  columns.push_back(kind_of_all<MethodComparison>(tables));
  return tabulate("comparisons", "measure and pair of methods", columns, comparisons.methods);
}

Table omnibus_table(const StudyTables& tables, const Comparisons& comparisons) {
  using O = OmnibusTest;
  const ColumnsOf<O> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [](const O& row) { return field(row.measure); }},
      {{"n", whole, "", "Participants with values of all methods"},
       [](const O& row) {
         return field_in(row.ranks, [](auto& test) { return test.participants; });
       }},
      {{"participants_left_out", whole, "", "Participants with a missing value"},
       [](const O& row) { return field(row.left_out); }},
      {{"censored", whole, "", "Right-censored times of the measure, which are left out"},
       [](const O& row) { return field(row.censored); }},
      of_variance("f", "F of the repeated-measures analysis of variance of log times",
                  [](auto& test) { return test.f; }),
      of_variance("df", "Degrees of freedom of the methods",
                  [](auto& test) { return test.degrees_of_freedom; }),
      of_variance("residual_df", "Degrees of freedom of the residuals",
                  [](auto& test) { return test.residual_degrees_of_freedom; }),
      of_variance("p_uncorrected", "P of F without a correction for sphericity",
                  [](auto& test) { return test.p; }),
      of_variance("epsilon_greenhouse_geisser", "Greenhouse and Geisser's epsilon",
                  [](auto& test) { return test.greenhouse_geisser; }),
      of_variance("p_greenhouse_geisser", "P with both degrees of freedom times that epsilon",
                  [](auto& test) { return test.p_greenhouse_geisser; }),
      of_variance("epsilon_huynh_feldt", "Huynh and Feldt's epsilon",
                  [](auto& test) { return test.huynh_feldt; }),
      of_variance("p_huynh_feldt", "P with both degrees of freedom times that epsilon",
                  [](auto& test) { return test.p_huynh_feldt; }),
      of_variance("partial_eta_squared", "Effect size of the methods",
                  [](auto& test) { return test.partial_eta_squared; }),
      of_ranks("friedman_chi_squared", "Friedman's statistic, corrected for ties",
               [](auto& test) { return test.chi_squared; }),
      of_ranks("friedman_df", "Its degrees of freedom",
               [](auto& test) { return test.degrees_of_freedom; }),
      of_ranks("p_friedman", "Its P", [](auto& test) { return test.p; }),
      of_ranks("kendalls_w", "Kendall's coefficient of concordance",
               [](auto& test) { return test.kendalls_w; }),
      kind_of_all<O>(tables)};
  return tabulate("omnibus", "measure", columns, comparisons.omnibus);
}

Table order_effects_table(const StudyTables& tables, const Comparisons& comparisons) {
  using O = OrderTest;
  const auto in_percent = [](const char* name, const char* description, auto value) {
    return ColumnOf<O>{{name, number, "%", description}, [=](const O& row) {
                         return row.is_time && row.change_per_step
                                    ? field(100.0 * std::expm1(value(*row.change_per_step)))
                                    : Field();
                       }};
  };
  const auto in_points = [](const char* name, const char* description, auto value) {
    return ColumnOf<O>{
        {name, number, "points", description}, [=](const O& row) {
          return !row.is_time && row.change_per_step ? field(value(*row.change_per_step)) : Field();
        }};
  };
  const auto plain = [](const char* name, const char* description, auto value) {
    return ColumnOf<O>{{name, number, "", description},
                       [=](const O& row) { return field_in(row.change_per_step, value); }};
  };
  const auto mean = [](const TTest& test) { return test.mean; };
  const auto low = [](const TTest& test) { return test.interval.low; };
  const auto high = [](const TTest& test) { return test.interval.high; };
  const ColumnsOf<O> columns = {
      {{"measure", text, "", "Id of the mark or rating"},
       [](const O& row) { return field(row.measure); }},
      {{"per", text, "",
        "A step: trial in the session, method in the scene, or carry-over, as fv after od: right "
        "after that method in the scene, against after the others"},
       [](const O& row) { return field(row.of); }},
      {{"n", whole, "", "Participants whose order varies"},
       [](const O& row) {
         return field_in(row.change_per_step, [](auto& test) { return test.n; });
       }},
      {{"censored", whole, "", "Right-censored times of the measure, which are left out"},
       [](const O& row) { return field(row.censored); }},
      in_percent("change_percent", "Of times: change with each step", mean),
      in_percent("ci95_low_percent", "Lower end of its 95 % interval", low),
      in_percent("ci95_high_percent", "Upper end of its 95 % interval", high),
      in_points("change_points", "Of ratings: change with each step", mean),
      in_points("ci95_low_points", "Lower end of its 95 % interval", low),
      in_points("ci95_high_points", "Upper end of its 95 % interval", high),
      plain("t", "t of the participants' slopes", [](const TTest& test) { return test.t; }),
      plain("df", "Its degrees of freedom",
            [](const TTest& test) { return test.degrees_of_freedom; }),
      plain("p", "Its two-sided P", [](const TTest& test) { return test.p; }),
      plain("d_z", "Effect size: mean over standard deviation of the slopes",
            [](const TTest& test) { return test.d_z; }),
      kind_of_all<O>(tables)};
  return tabulate("order_effects", "measure and way of counting", columns, comparisons.order);
}

}  // namespace foveola::analysis
