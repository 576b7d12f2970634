#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/printed_results.h"

namespace foveola::analysis {
namespace {

std::string bracketed(const Interval& interval, double scale, int decimals) {
  return fmt::format("[{}, {}]", fixed(scale * interval.low, decimals),
                     fixed(scale * interval.high, decimals));
}

/// A pseudo-median with its interval, in the comparison's unit times `scale`.
std::string pseudo_median_text(const MethodComparison& row, double scale, int decimals) {
  if (!row.pseudo_median) {
    return "–";
  }
  const PseudoMedian& found = *row.pseudo_median;
  const auto scaled = [&](double tested) { return scale * row.in_unit(tested); };
  Estimate estimate{found.n, scaled(found.value), std::nullopt};
  if (found.interval) {
    estimate.interval = {scaled(found.interval->low), scaled(found.interval->high)};
  }
  return with_interval(estimate, decimals);
}

std::string rank_biserial(const MethodComparison& row) {
  return fixed(row.ranks ? std::optional(row.ranks->rank_biserial) : std::nullopt, 2);
}

std::vector<std::string> ratio_row(const MethodComparison& row) {
  std::vector<std::string> cells = {compared_in_words(row), std::to_string(row.n)};
  if (row.ratio) {
    const TTest& logs = row.ratio->logs;
    cells.push_back(fmt::format("{:.1f} {}", 100.0 * row.ratio->ratio,
                                bracketed(row.ratio->interval, 100.0, 1)));
    cells.push_back(row.ratio_bca ? bracketed(*row.ratio_bca, 100.0, 1) : "–");
    cells.push_back(fmt::format("{:.2f} ({:g})", logs.t, logs.degrees_of_freedom));
    cells.push_back(p_value(logs.p));
    cells.push_back(fmt::format("{:.2f}", logs.d_z));
  } else {
    cells.push_back(row.mean ? fixed(100.0 * row.in_unit(*row.mean), 1) : "–");
    cells.insert(cells.end(), 4, "–");
  }
  cells.push_back(std::to_string(row.complete.n));
  cells.push_back(row.complete.ratio
                      ? fmt::format("{:.1f} {}", 100.0 * row.complete.ratio->ratio,
                                    bracketed(row.complete.ratio->interval, 100.0, 1))
                      : "–");
  return cells;
}

std::vector<std::string> rating_row(const MethodComparison& row) {
  return {compared_in_words(row),
          std::to_string(row.n),
          row.points
              ? fmt::format("{:.2f} {}", row.points->mean, bracketed(row.points->interval, 1.0, 2))
              : fixed(row.mean, 2),
          pseudo_median_text(row, 1.0, 2),
          row.ranks ? p_value(row.ranks->p) : "–",
          rank_biserial(row)};
}

std::vector<std::string> equivalence_row(const MethodComparison& row) {
  std::vector<std::string> cells = {
      compared_in_words(row), row.planned ? "planned" : "exploratory",
      fmt::format("{} {:g}", row.is_time ? "factor" : "±", *row.margin)};
  if (row.equivalent) {
    const std::optional<Interval>& interval = row.equivalent->interval;
    cells.push_back(interval ? bracketed(row.in_unit(*interval), 1.0, 2) : "–");
    cells.push_back(p_value(row.equivalent->p));
    cells.push_back(row.p_equivalent_holm ? p_value(*row.p_equivalent_holm) : "–");
    cells.emplace_back(name_of(row.primary->kind));
  } else {
    cells.insert(cells.end(), 3, "–");
    cells.push_back("none: " + row.no_equivalence);
  }
  return cells;
}

std::vector<std::string> influence_row(const MethodComparison& row) {
  if (!row.influence) {
    return {compared_in_words(row), "none: " + row.no_influence, "–", "–", "–"};
  }
  const double scale = row.is_time ? 100.0 : 1.0;
  const auto estimate = [&](double value) {
    return fmt::format("{:.{}f} {}", scale * row.in_unit(value), row.is_time ? 1 : 2,
                       row.is_time ? "%" : "points");
  };
  return {compared_in_words(row), estimate(row.influence->estimates.low),
          row.influence->without_low, estimate(row.influence->estimates.high),
          row.influence->without_high};
}

std::vector<std::string> variance_row(const OmnibusTest& row) {
  const VarianceAnalysis& found = *row.variance;
  return {row.measure,
          fmt::format("{:.2f} ({:.2f}, {:.2f})", found.f,
                      found.greenhouse_geisser * found.degrees_of_freedom,
                      found.greenhouse_geisser * found.residual_degrees_of_freedom),
          fixed(found.greenhouse_geisser, 3),
          p_value(found.p_greenhouse_geisser),
          fixed(found.partial_eta_squared, 2),
          std::to_string(row.left_out)};
}

std::vector<std::string> friedman_row(const OmnibusTest& row) {
  return {row.measure,
          fmt::format("{:.2f} ({:g})", row.ranks->chi_squared, row.ranks->degrees_of_freedom),
          p_value(row.ranks->p), fixed(row.ranks->kendalls_w, 2), std::to_string(row.left_out)};
}

/// The change with each step: of times in per cent, of ratings in points.
std::string change_text(const OrderTest& row) {
  const TTest& test = *row.change_per_step;
  if (!row.is_time) {
    return fmt::format("{:.2f} {} points", test.mean, bracketed(test.interval, 1.0, 2));
  }
  const Interval change = {std::expm1(test.interval.low), std::expm1(test.interval.high)};
  return fmt::format("{:.1f} {} %", 100.0 * std::expm1(test.mean), bracketed(change, 100.0, 1));
}

}  // namespace

std::string compared_in_words(const MethodComparison& row) {
  return fmt::format("{} {} {}, {}", method_label(row.method), row.is_time ? "/" : "−",
                     method_label(row.reference), row.measure);
}

PrintedTable printed_ratios(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "ratios-over-participants";
  table.title = "Times over participants, in these scenes.";
  table.note =
      "Geometric mean ratio of the participants’ pairs with t interval, then BCa bootstrap "
      "interval; paired t on logarithms; the same of the scenes in which all methods were "
      "measured (complete cases).";
  table.note = joined(table.note, comparisons.censored_times);
  table.columns = {"Methods, mark", "n",           "ratio, % [95 %]",
                   "BCa 95 %",      "t (df)",      "P",
                   "d_z",           "n, complete", "ratio, % [95 %], complete"};
  for (const MethodComparison& row : comparisons.methods) {
    if (row.is_time) {
      table.rows.push_back(ratio_row(row));
    }
  }
  return table;
}

PrintedTable printed_ranks(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "ranks";
  table.title = "Times by ranks.";
  table.note =
      "Wilcoxon signed-rank test of the log ratios, its effect size, and Hodges and Lehmann’s "
      "estimate of the ratio.";
  table.note = joined(table.note, comparisons.censored_times);
  table.columns = {"Methods, mark", "n", "pseudo-median, % [95 %]", "P, Wilcoxon", "r, rank"};
  for (const MethodComparison& row : comparisons.methods) {
    if (!row.is_time) {
      continue;
    }
    table.rows.push_back(
        {compared_in_words(row), std::to_string(row.n), pseudo_median_text(row, 100.0, 1),
         row.ranks ? p_value(row.ranks->p) + (row.ranks->exact ? "" : " (approximate)") : "–",
         rank_biserial(row)});
  }
  return table;
}

PrintedTable printed_rating_differences(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "rating-differences";
  table.title = "Ratings over participants, in these scenes.";
  table.note =
      "Of each participant’s mean over scenes. Wilcoxon signed-rank, exact for up to 200 "
      "participants; the difference of means is given, too.";
  table.columns = {"Methods, rating",      "n",           "difference [95 %]",
                   "pseudo-median [95 %]", "P, Wilcoxon", "r, rank"};
  for (const MethodComparison& row : comparisons.methods) {
    if (!row.is_time) {
      table.rows.push_back(rating_row(row));
    }
  }
  return table;
}

PrintedTable printed_equivalence(const Comparisons& comparisons) {
  const double confidence_percent = 100.0 * (1.0 - 2.0 * comparisons.plan.alpha);
  PrintedTable table;
  table.id = "equivalence";
  table.title = "Equivalence.";
  table.note = fmt::format(
      "Two one-sided tests of the primary analysis against the protocol’s margins, or the reason "
      "why it has none. The difference is too small to matter where P is below {0:g}; where P is "
      "not "
      "adjusted, the {1:g} % interval of a t test then lies within the margins. P of the planned "
      "comparisons is adjusted by Holm’s method over those with a margin, a family of their own; "
      "exploratory ones are not adjusted.",
      comparisons.plan.alpha, confidence_percent);
  table.columns = {"Methods, measure",
                   "status",
                   "margin",
                   fmt::format("{:g} % interval", confidence_percent),
                   "P",
                   "P, Holm",
                   "analysis"};
  for (const MethodComparison& row : comparisons.methods) {
    if (row.margin) {
      table.rows.push_back(equivalence_row(row));
    }
  }
  return table;
}

PrintedTable printed_variance(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "omnibus-times";
  table.title = "Times, all methods together.";
  table.note =
      "Repeated-measures analysis of variance of log times, with Greenhouse and Geisser’s "
      "correction in the degrees of freedom and in P; participants with a missing value are left "
      "out.";
  table.note = joined(table.note, comparisons.censored_times);
  table.columns = {"Mark", "F (df)", "ε", "P", "partial η²", "left out"};
  for (const OmnibusTest& row : comparisons.omnibus) {
    if (row.variance) {
      table.rows.push_back(variance_row(row));
    }
  }
  return table;
}

PrintedTable printed_friedman(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "omnibus-ranks";
  table.title = "All methods together, by ranks.";
  table.note =
      "Friedman’s test, with ties, and Kendall’s W; participants with a missing value are left "
      "out.";
  table.note = joined(table.note, comparisons.censored_times);
  table.columns = {"Measure", "χ² (df)", "P", "W", "left out"};
  for (const OmnibusTest& row : comparisons.omnibus) {
    if (row.ranks) {
      table.rows.push_back(friedman_row(row));
    }
  }
  return table;
}

PrintedTable printed_order_effects(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "order-effects";
  table.title = "Order and learning.";
  table.note =
      "Change with each step, with 95 % interval over participants; the means of participants, "
      "scenes and methods are subtracted first. Carry-over, where every method follows every "
      "other: “fv after od” is the change of fv right after od in a scene, against fv after the "
      "others. P is not adjusted.";
  table.note = joined(table.note, comparisons.censored_times);
  table.columns = {"Measure, per", "n", "change [95 %]", "t (df)", "P", "d_z"};
  for (const OrderTest& row : comparisons.order) {
    const std::string name = fmt::format("{}, {}", row.measure, row.of);
    if (!row.change_per_step) {
      table.rows.push_back({name, "–", "–", "–", "–", "–"});
      continue;
    }
    const TTest& test = *row.change_per_step;
    table.rows.push_back({name, std::to_string(test.n), change_text(row),
                          fmt::format("{:.2f} ({:g})", test.t, test.degrees_of_freedom),
                          p_value(test.p), fixed(test.d_z, 2)});
  }
  return table;
}

PrintedTable printed_influence(const Comparisons& comparisons) {
  PrintedTable table;
  table.id = "influence";
  table.title = "Without one participant.";
  table.note =
      "The smallest and the largest primary estimate of the planned comparisons when each "
      "participant in turn is left out, and who that is.";
  table.columns = {"Methods, measure", "smallest", "without", "largest", "without"};
  for (const MethodComparison& row : comparisons.methods) {
    if (row.planned) {
      table.rows.push_back(influence_row(row));
    }
  }
  return table;
}

std::vector<PrintedTable> sensitivity_tables(const Comparisons& comparisons) {
  return {printed_models(comparisons),
          printed_influence(comparisons),
          printed_ratios(comparisons),
          printed_ranks(comparisons),
          printed_rating_differences(comparisons),
          printed_equivalence(comparisons),
          printed_variance(comparisons),
          printed_friedman(comparisons),
          printed_order_effects(comparisons)};
}

}  // namespace foveola::analysis
