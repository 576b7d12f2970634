#include <cmath>

#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

std::string p_or_dash(const std::optional<double>& p) { return p ? p_value(*p) : "–"; }

std::string bracketed(const Interval& interval, double scale, int decimals) {
  return fmt::format("[{}, {}]", fixed(scale * interval.low, decimals),
                     fixed(scale * interval.high, decimals));
}

std::string pair_name(const MethodComparison& row) {
  return fmt::format("{} / {}, {}", method_label(row.method), method_label(row.reference),
                     row.measure);
}

std::vector<std::string> ratio_row(const MethodComparison& row) {
  std::vector<std::string> cells = {pair_name(row), std::to_string(row.n)};
  if (row.ratio) {
    const TTest& logs = row.ratio->logs;
    cells.push_back(fmt::format("{:.1f} {}", 100.0 * row.ratio->ratio,
                                bracketed(row.ratio->interval, 100.0, 1)));
    cells.push_back(row.ratio_bca ? bracketed(*row.ratio_bca, 100.0, 1) : "–");
    cells.push_back(fmt::format("{:.2f} ({:g})", logs.t, logs.degrees_of_freedom));
    cells.push_back(p_value(logs.p));
    cells.push_back(p_or_dash(row.p_holm));
    cells.push_back(fmt::format("{:.2f}", logs.d_z));
  } else {
    cells.insert(cells.end(), 6, "–");
  }
  cells.push_back(row.ranks ? p_value(row.ranks->p) : "–");
  return cells;
}

std::string ratio_table(const StudyTables& tables, const Comparisons& comparisons, bool primary) {
  HtmlTable table;
  table.caption_html =
      caption_start(
          tables, primary ? "Planned comparisons of times." : "Exploratory comparisons of times.") +
      "Ratio of times in per cent: geometric mean over participants with t interval, then BCa "
      "bootstrap interval; paired t on logarithms; Wilcoxon signed-rank.";
  table.columns = {"Methods, mark", "n",   "ratio, % [95 %]", "BCa 95 %", "t (df)", "P",
                   "P, Holm",       "d_z", "P, Wilcoxon"};
  for (const MethodComparison& row : comparisons.methods) {
    if (!row.is_of_ratings() && row.primary == primary) {
      table.rows.push_back(ratio_row(row));
    }
  }
  return table.rows.empty() ? "" : render(table);
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

std::string rank_sums(const MethodComparison& row) {
  return row.ranks ? fmt::format("{:g} / {:g}", row.ranks->w_plus, row.ranks->w_minus) : "–";
}

std::string rank_table(const StudyTables& tables, const Comparisons& comparisons) {
  HtmlTable table;
  table.caption_html = caption_start(tables, "Times by ranks.") +
                       "Wilcoxon signed-rank test of the log ratios, its effect size, and Hodges "
                       "and Lehmann’s estimate of the ratio.";
  table.columns = {"Methods, mark",          "n", "zeros", "W+ / W−", "P, Wilcoxon", "r, rank",
                   "pseudo-median, % [95 %]"};
  for (const MethodComparison& row : comparisons.methods) {
    if (row.is_of_ratings()) {
      continue;
    }
    table.rows.push_back(
        {pair_name(row) + (row.primary ? " (planned)" : ""), std::to_string(row.n),
         row.ranks ? std::to_string(row.ranks->zeros) : "–", rank_sums(row),
         row.ranks ? p_value(row.ranks->p) + (row.ranks->exact ? "" : " (approximate)") : "–",
         fixed(row.ranks ? std::optional(row.ranks->rank_biserial) : std::nullopt, 2),
         pseudo_median_text(row, 100.0, 1)});
  }
  return table.rows.empty() ? "" : render(table);
}

std::vector<std::string> rating_row(const MethodComparison& row) {
  return {fmt::format("{} − {}{}", method_label(row.method), method_label(row.reference),
                      row.primary ? " (planned)" : ""),
          std::to_string(row.n),
          row.points
              ? fmt::format("{:.2f} {}", row.points->mean, bracketed(row.points->interval, 1.0, 2))
              : "–",
          pseudo_median_text(row, 1.0, 2),
          rank_sums(row),
          row.ranks ? p_value(row.ranks->p) : "–",
          p_or_dash(row.p_holm),
          fixed(row.ranks ? std::optional(row.ranks->rank_biserial) : std::nullopt, 2)};
}

std::string rating_table(const StudyTables& tables, const Comparisons& comparisons) {
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Artifact ratings, comparisons of methods.") +
      "Of each participant’s mean over scenes. Wilcoxon signed-rank, exact for up to 200 "
      "participants; the difference of means is given too, as in the published study.";
  table.columns = {"Methods",
                   "n",
                   "difference, points [95 %]",
                   "pseudo-median [95 %]",
                   "W+ / W−",
                   "P, Wilcoxon",
                   "P, Holm",
                   "r, rank"};
  for (const MethodComparison& row : comparisons.methods) {
    if (row.is_of_ratings()) {
      table.rows.push_back(rating_row(row));
    }
  }
  return table.rows.empty() ? "" : render(table);
}

std::string equivalence_table(const StudyTables& tables, const Comparisons& comparisons) {
  HtmlTable table;
  table.caption_html = caption_start(tables, "Equivalence.") +
                       "Two one-sided t tests against the protocol’s margins. Below the level, the "
                       "difference is too small to matter.";
  table.columns = {"Methods, measure", "margin", "interval", "P"};
  for (const MethodComparison& row : comparisons.methods) {
    if (!row.equivalent) {
      continue;
    }
    table.rows.push_back({pair_name(row),
                          row.is_of_ratings() ? fmt::format("± {:g} points", *row.margin)
                                              : fmt::format("factor {:g}", *row.margin),
                          bracketed(row.in_unit(row.equivalent->interval), 1.0, 2),
                          p_value(row.equivalent->p)});
  }
  return table.rows.empty() ? "" : render(table);
}

std::vector<std::string> omnibus_row(const OmnibusTest& row) {
  std::vector<std::string> cells = {row.measure};
  if (row.variance) {
    const VarianceAnalysis& found = *row.variance;
    cells.push_back(fmt::format("{:.2f} ({:.2f}, {:.2f})", found.f,
                                found.greenhouse_geisser * found.degrees_of_freedom,
                                found.greenhouse_geisser * found.residual_degrees_of_freedom));
    cells.push_back(fmt::format("{:.3f} / {:.3f}", found.greenhouse_geisser, found.huynh_feldt));
    cells.push_back(p_value(found.p_greenhouse_geisser));
    cells.push_back(p_value(found.p_huynh_feldt));
    cells.push_back(fmt::format("{:.2f}", found.partial_eta_squared));
  } else {
    cells.insert(cells.end(), 5, "–");
  }
  if (row.ranks) {
    cells.push_back(
        fmt::format("{:.2f} ({:g})", row.ranks->chi_squared, row.ranks->degrees_of_freedom));
    cells.push_back(p_value(row.ranks->p));
    cells.push_back(fmt::format("{:.2f}", row.ranks->kendalls_w));
  } else {
    cells.insert(cells.end(), 3, "–");
  }
  cells.push_back(std::to_string(row.left_out));
  return cells;
}

std::string omnibus_table(const StudyTables& tables, const Comparisons& comparisons) {
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Omnibus tests, of all methods together.") +
      "Repeated-measures analysis of variance of log times with Greenhouse and Geisser’s "
      "correction, the degrees of freedom so corrected, and Huynh and Feldt’s beside it; "
      "Friedman’s "
      "test, with ties; participants with a missing value are left out of both.";
  table.columns = {"Measure",    "F (df)",  "ε, GG / HF",  "P, GG", "P, HF",
                   "partial η²", "χ² (df)", "P, Friedman", "W",     "left out"};
  for (const OmnibusTest& row : comparisons.omnibus) {
    table.rows.push_back(omnibus_row(row));
  }
  return render(table);
}

std::string order_table(const StudyTables& tables, const Comparisons& comparisons) {
  HtmlTable table;
  table.caption_html = caption_start(tables, "Order and learning.") +
                       "Change of the time with each step, with 95 % interval over participants; "
                       "the means of participants, scenes and methods are subtracted first.";
  table.columns = {"Mark, per", "n", "change, % [95 %]", "t (df)", "P", "d_z"};
  for (const OrderTest& row : comparisons.order) {
    const std::string name = fmt::format("{}, {}", name_of(row.mark), row.of);
    if (!row.change_per_step) {
      table.rows.push_back({name, "–", "–", "–", "–", "–"});
      continue;
    }
    const TTest& test = *row.change_per_step;
    const Interval change = {std::expm1(test.interval.low), std::expm1(test.interval.high)};
    table.rows.push_back(
        {name, std::to_string(test.n),
         fmt::format("{:.1f} {}", 100.0 * std::expm1(test.mean), bracketed(change, 100.0, 1)),
         fmt::format("{:.2f} ({:g})", test.t, test.degrees_of_freedom), p_value(test.p),
         fixed(test.d_z, 2)});
  }
  return render(table);
}

std::string plan_in_words(const Comparisons& comparisons, std::size_t participants) {
  const study::AnalysisPlan& plan = comparisons.plan;
  std::string text =
      plan.primary.empty()
          ? "The protocol plans no comparison: all of these are exploratory."
          : fmt::format(
                "The protocol planned {} before there were data, at a level of {:g} for all "
                "of them together (Holm); everything else is exploratory, and adjusted "
                "within its measure.",
                counted(plan.primary.size(), "primary comparison"), plan.alpha);
  if (plan.participants && static_cast<std::size_t>(*plan.participants) != participants) {
    text += fmt::format(" It planned {}; {} analysed.",
                        counted(static_cast<std::size_t>(*plan.participants), "participant"),
                        participants == 1 ? "1 is" : fmt::format("{} are", participants));
  }
  return text;
}

}  // namespace

std::string comparisons_section(const StudyTables& tables, const Comparisons& comparisons) {
  if (tables.set.methods.size() < 2) {
    return "";
  }
  return html_section(
      "Comparisons of methods",
      fmt::format("<p>{}</p>\n",
                  escape_html(plan_in_words(comparisons, tables.set.participants.size()))) +
          ratio_table(tables, comparisons, true) + ratio_table(tables, comparisons, false) +
          rank_table(tables, comparisons) + rating_table(tables, comparisons) +
          equivalence_table(tables, comparisons) + omnibus_table(tables, comparisons) +
          order_table(tables, comparisons));
}

}  // namespace foveola::analysis
