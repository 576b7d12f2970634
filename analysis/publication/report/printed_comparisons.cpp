#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/report/printed_results.h"
#include "analysis/publication/tables/result_tables.h"
#include "analysis/tables/row_text.h"

namespace foveola::analysis {
namespace {

/// Returns the table with columns that name the methods and the measure, "FV / OD, outline", and
/// say whether this is a time. Times are joined by "/", ratings by "−".
Table with_compared(const Table& results, const std::vector<bool>& are_times) {
  Table table = with_method_labels(results);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const char* name =
        are_times[i] ? "{method} / {reference}, {measure}" : "{method} − {reference}, {measure}";
    const std::optional<std::string> compared = fill(name, table, table.rows[i]);
    table.rows[i].insert(table.rows[i].end(), {field(compared), field(bool(are_times[i]))});
  }
  table.columns.push_back({"compared", ColumnType::text, "", ""});
  table.columns.push_back({"is_time", ColumnType::truth, "", ""});
  return table;
}

Table named_comparisons(const std::vector<Table>& results, const Comparisons& comparisons) {
  std::vector<bool> are_times;
  for (const MethodComparison& row : comparisons.methods) {
    are_times.push_back(row.is_time);
  }
  return with_compared(table_named(results, "comparisons"), are_times);
}

PrintedTable printed_models(const std::vector<Table>& results) {
  const Table& models = table_named(results, "models");
  return print_rows(
      {.id = "models",
       .title = "Models by R.",
       .note = "Crossed and Tobit models of log times: ratios in per cent; crossed models of "
               "ratings with many points: points; cumulative link mixed models of the other "
               "ratings: odds ratios of a higher one. Standard deviations are of the difference "
               "between the methods, in natural-log units, points or logits."},
      with_compared(models, std::vector<bool>(models.rows.size(), true)), "",
      {{"Methods, measure", "{compared}"},
       {"model", "{model}"},
       {"trials", "{trials}"},
       {"right-censored", "{censored}"},
       {"estimate [95 %]",
        "{scale=ratio}{estimate:100*exp.1}| [{ci95_low:100*exp.1}, {ci95_high:100*exp.1}]| %",
        "{scale=odds ratio}{estimate:exp.2}| [{ci95_low:exp.2}, {ci95_high:exp.2}]| odds ratio",
        "{estimate:.2}| [{ci95_low:.2}, {ci95_high:.2}]| points"},
       {"df", "{df:.1}"},
       {"P", "{p:p}"},
       {"SD, participants", "{participant_sd:.3}"},
       {"SD, scenes", "{scene_sd:.3}"},
       {"R says", "{note}", ""}});
}

PrintedTable printed_influence(const Table& compared) {
  const auto estimate = [](const std::string& column) {
    return std::pair("{scale=ratio}{" + column + ":100*.1} %", "{" + column + ":.2} points");
  };
  const auto [smallest_ratio, smallest_points] = estimate("leave_one_out_low");
  const auto [largest_ratio, largest_points] = estimate("leave_one_out_high");
  return print_rows(
      {.id = "influence",
       .title = "Without one participant.",
       .note = "Minimum and maximum of the primary estimate of a planned comparison when each "
               "participant in turn is left out, with that participant."},
      compared, "{status=planned}",
      {{"Methods, measure", "{compared}"},
       {"smallest", smallest_ratio, smallest_points, "none: |{leave_one_out_note}"},
       {"without", "{leave_one_out_low_without}"},
       {"largest", largest_ratio, largest_points},
       {"without", "{leave_one_out_high_without}"}});
}

PrintedTable printed_ratios(const Table& compared, const Comparisons& comparisons) {
  return print_rows(
      {.id = "ratios-over-participants",
       .title = "Times: tests over participants, in these scenes.",
       .note = join_sentences(
           "Geometric mean ratio of the participants’ pairs with t interval, then BCa "
           "bootstrap interval; paired t on logarithms; the same over the scenes in which "
           "all methods were measured (complete cases).",
           comparisons.censored_times)},
      compared, "{is_time=TRUE}",
      {{"Methods, mark", "{compared}"},
       {"n", "{n}"},
       {"ratio, % [95 %]", "{ratio_percent:.1}| [{ci95_low_percent:.1}, {ci95_high_percent:.1}]"},
       {"BCa 95 %", "[{bca95_low_percent:.1}, {bca95_high_percent:.1}]"},
       {"t (df)", "{t:.2} ({df:g})"},
       {"P", "{p_t:p}"},
       {"d_z", "{d_z:.2}"},
       {"n, complete", "{n_complete}"},
       {"ratio, % [95 %], complete",
        "{complete_ratio_percent:.1} [{complete_ci95_low_percent:.1}, "
        "{complete_ci95_high_percent:.1}]"}});
}

PrintedTable printed_ranks(const Table& compared, const Comparisons& comparisons) {
  return print_rows({.id = "ranks",
                     .title = "Times: rank tests.",
                     .note = join_sentences(
                         "Wilcoxon signed-rank test of the log ratios, its effect size, and Hodges "
                         "and Lehmann’s estimate of the ratio.",
                         comparisons.censored_times)},
                    compared, "{is_time=TRUE}",
                    {{"Methods, mark", "{compared}"},
                     {"n", "{n}"},
                     {"pseudo-median, % [95 %]",
                      "{pseudo_median_ratio_percent:.1}| [{pseudo_median_low_ratio_percent:.1}, "
                      "{pseudo_median_high_ratio_percent:.1}]"},
                     {"P, Wilcoxon", "{p_wilcoxon:p}{wilcoxon_exact:/ (approximate)}"},
                     {"r, rank", "{rank_biserial:.2}"}});
}

PrintedTable printed_rating_differences(const Table& compared) {
  return print_rows(
      {.id = "rating-differences",
       .title = "Ratings: tests over participants, in these scenes.",
       .note = "Of each participant’s mean over scenes. Wilcoxon signed-rank, exact for up to 200 "
               "participants; the difference of means is given as well."},
      compared, "{is_time=FALSE}",
      {{"Methods, rating", "{compared}"},
       {"n", "{n}"},
       {"difference [95 %]",
        "{difference_points:.2}| [{ci95_low_points:.2}, {ci95_high_points:.2}]"},
       {"pseudo-median [95 %]",
        "{pseudo_median_points:.2}| [{pseudo_median_low_points:.2}, "
        "{pseudo_median_high_points:.2}]"},
       {"P, Wilcoxon", "{p_wilcoxon:p}"},
       {"r, rank", "{rank_biserial:.2}"}});
}

PrintedTable printed_equivalence(const Table& compared, const study::AnalysisPlan& plan) {
  const double confidence_percent = 100.0 * (1.0 - 2.0 * plan.alpha);
  return print_rows(
      {.id = "equivalence",
       .title = "Equivalence.",
       .note = fmt::format(
           "Two one-sided tests of the primary analysis against the protocol’s margins, or the "
           "reason why it has none. The difference is too small to matter where P is below {0:g}; "
           "where P is not adjusted, the {1:g} % interval of a t test then lies within the "
           "margins. P of the planned comparisons is adjusted by Holm’s method over those with a "
           "margin, a family of their own; exploratory ones are not adjusted.",
           plan.alpha, confidence_percent)},
      compared, "{equivalence_margin}",
      {{"Methods, measure", "{compared}"},
       {"status", "{status}"},
       {"margin", "{is_time=TRUE}factor {equivalence_margin:g}", "± {equivalence_margin:g}"},
       {fmt::format("{:g} % interval", confidence_percent),
        "[{equivalence_interval_low:.2}, {equivalence_interval_high:.2}]"},
       {"P", "{p_equivalence:p}"},
       {"P, Holm", "{p_equivalence_holm:p}"},
       {"analysis", "none: {equivalence_note}", "{analysis}"}});
}

PrintedTable printed_variance(const Table& omnibus, const Comparisons& comparisons) {
  return print_rows(
      {.id = "omnibus-times",
       .title = "Times: analysis of variance of all methods.",
       .note = join_sentences(
           "Repeated-measures analysis of variance of log times, with Greenhouse and "
           "Geisser’s correction in the degrees of freedom and in P; participants with "
           "a missing value are left out.",
           comparisons.censored_times)},
      omnibus, "{f}",
      {{"Mark", "{measure}"},
       {"F (df)", "{f:.2} ({corrected_df:.2}, {corrected_residual_df:.2})"},
       {"ε", "{epsilon_greenhouse_geisser:.3}"},
       {"P", "{p_greenhouse_geisser:p}"},
       {"partial η²", "{partial_eta_squared:.2}"},
       {"left out", "{participants_left_out}"}});
}

PrintedTable printed_friedman(const Table& omnibus, const Comparisons& comparisons) {
  return print_rows({.id = "omnibus-ranks",
                     .title = "Times and ratings: rank test of all methods.",
                     .note = join_sentences(
                         "Friedman’s test, with ties, and Kendall’s W; participants with a missing "
                         "value are left out.",
                         comparisons.censored_times)},
                    omnibus, "{p_friedman}",
                    {{"Measure", "{measure}"},
                     {"χ² (df)", "{friedman_chi_squared:.2} ({friedman_df:g})"},
                     {"P", "{p_friedman:p}"},
                     {"W", "{kendalls_w:.2}"},
                     {"left out", "{participants_left_out}"}});
}

PrintedTable printed_order_effects(const Table& order, const Comparisons& comparisons) {
  return print_rows(
      {.id = "order-effects",
       .title = "Order and learning.",
       .note = join_sentences(
           "Change per step, with its 95 % confidence interval over participants; the means of "
           "participants, scenes and methods are subtracted first. Carry-over, where "
           "every method follows every other: “fv after od” is the change of fv right "
           "after od in a scene, against fv after the others. P is not adjusted.",
           comparisons.censored_times)},
      order, "",
      {{"Measure, per", "{measure}, {per}"},
       {"n", "{n}"},
       {"change [95 %]", "{change_percent:.1} [{ci95_low_percent:.1}, {ci95_high_percent:.1}] %",
        "{change_points:.2} [{ci95_low_points:.2}, {ci95_high_points:.2}] points"},
       {"t (df)", "{t:.2} ({df:g})"},
       {"P", "{p:p}"},
       {"d_z", "{d_z:.2}"}});
}

Table with_corrected_df(Table omnibus) {
  for (const char* df : {"df", "residual_df"}) {
    omnibus.columns.push_back({std::string("corrected_") + df, ColumnType::number, "", ""});
    for (Row& row : omnibus.rows) {
      const auto epsilon = number_of(field_in(omnibus, row, "epsilon_greenhouse_geisser"));
      row.push_back(epsilon ? Field(*epsilon * *number_of(field_in(omnibus, row, df))) : Field());
    }
  }
  return omnibus;
}

PrintedTable printed_primary(const Table& compared, const Comparisons& comparisons, bool planned) {
  std::vector<PrintedColumn> columns = {
      {"Methods, measure", "{compared}"},
      {"n", "{n}"},
      {"pairs", "{pairs}"},
      // A single participant, or constant differences, allow an estimate only.
      {"estimate [95 %]",
       "{scale=ratio}{estimate:100*.1}| [{estimate_low:100*.1}, {estimate_high:100*.1}]| %",
       "{estimate:.2}| [{estimate_low:.2}, {estimate_high:.2}]| {scale}", "{ratio_percent:.1} %",
       "{difference_points:.2} points"},
      {"speed-up [95 %]",
       "{scale=ratio}{estimate:1/.2}| [{estimate_high:1/.2}, {estimate_low:1/.2}]| ×",
       "{ratio_percent:100/.2} ×"},
      {"P", "{p:p}"},
      {"P, Holm", "{p_holm:p}"},
      {"analysis", "{analysis}| ({analysis_note})|; R: {analysis_warning}", "{missing}"}};
  if (!planned) {
    std::erase_if(columns, [](const PrintedColumn& column) { return column.heading == "P, Holm"; });
  }
  return print_rows(
      {.id = planned ? "planned-comparisons" : "exploratory-comparisons",
       .title = planned ? "Planned comparisons." : "Exploratory comparisons, P-values unadjusted.",
       .note = fmt::format(
           "The primary analysis of each, with its 95 % confidence interval. {} Speed-up: how many "
           "times "
           "sooner the mark came.",
           comparisons.plan.scenes == study::SceneEffects::random
               ? "Mixed and Tobit models generalise to scenes and participants like these; a "
                 "paired t and "
                 "signed ranks generalise to participants like these, for these scenes only."
               : "All estimates generalise to participants like these, for these scenes only.")},
      compared, planned ? "{status=planned}" : "{status=exploratory}", columns);
}

}  // namespace

std::vector<PrintedTable> primary_tables(const std::vector<Table>& results,
                                         const Comparisons& comparisons) {
  const Table compared = named_comparisons(results, comparisons);
  return {printed_primary(compared, comparisons, true),
          printed_primary(compared, comparisons, false)};
}

std::vector<PrintedTable> sensitivity_tables(const std::vector<Table>& results,
                                             const Comparisons& comparisons) {
  const Table compared = named_comparisons(results, comparisons);
  const Table omnibus = with_corrected_df(table_named(results, "omnibus"));
  return {printed_models(results),
          printed_influence(compared),
          printed_ratios(compared, comparisons),
          printed_ranks(compared, comparisons),
          printed_rating_differences(compared),
          printed_equivalence(compared, comparisons.plan),
          printed_variance(omnibus, comparisons),
          printed_friedman(omnibus, comparisons),
          printed_order_effects(table_named(results, "order_effects"), comparisons)};
}

}  // namespace foveola::analysis
