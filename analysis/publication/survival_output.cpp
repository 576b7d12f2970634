#include "analysis/publication/survival_output.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_drawing.h"
#include "analysis/publication/logarithmic_axis.h"
#include "analysis/publication/result_tables.h"

namespace foveola::analysis {
namespace {

using enum ColumnType;

std::string median_text(const SurvivalCurve& curve) {
  if (!curve.median) {
    return "not reached";
  }
  const auto end = [](const std::optional<double>& value) { return value ? fixed(value, 1) : "∞"; };
  return fmt::format("{:.1f} [{}, {}]", curve.median->value, fixed(curve.median->low, 1),
                     end(curve.median->high));
}

/// The curve as points of (time, share without a mark), from `start` on; of thousands of steps only
/// so many as can be seen.
std::string curve_data(const SurvivalCurve& curve, std::size_t method, double start) {
  std::string data = fmt::format("$method{} << END\n{} 1\n", method, start);
  constexpr std::size_t most_steps = 1000;
  const std::size_t stride = 1 + curve.steps.size() / most_steps;
  for (std::size_t i = 0; i < curve.steps.size(); i += stride) {
    data += fmt::format("{} {}\n", curve.steps[i].time, curve.steps[i].survival);
  }
  data += fmt::format("{} {}\n", curve.steps.back().time, curve.steps.back().survival);
  return data + "END\n";
}

/// The points of the curve at which trials were right-censored.
std::string censored_data(const SurvivalCurve& curve, std::size_t method) {
  std::string data = fmt::format("$censored{} << END\n", method);
  for (const SurvivalStep& step : curve.steps) {
    data += step.censored > 0 ? fmt::format("{} {}\n", step.time, step.survival) : "";
  }
  return data + "END\n";
}

}  // namespace

Table time_to_mark_table(const StudyTables& tables) {
  using S = MarkSurvival;
  const auto of_median = [](const char* name, const char* description, auto value) {
    return ColumnOf<S>{{name, number, "s", description}, [=](const S& row) {
                         return row.curve.median ? field(std::optional(value(*row.curve.median)))
                                                 : Field();
                       }};
  };
  const auto of_mean = [](const char* name, const char* description, auto value) {
    return ColumnOf<S>{{name, number, "s", description},
                       [=](const S& row) { return field_in(row.restricted, value); }};
  };
  using Median = SurvivalMedian;
  const ColumnsOf<S> columns = {
      {{"mark", text, "", "Id of the mark"}, [](const S& row) { return field(row.mark); }},
      {{"method", text, "", "Id of the method"}, [](const S& row) { return field(row.method); }},
      {{"trials", whole, "", "Trials with a time or a right-censored one"},
       [](const S& row) { return field(row.curve.n); }},
      {{"reached", whole, "", "Trials in which the mark was reached"},
       [](const S& row) { return field(row.curve.events); }},
      {{"right_censored", whole, "", "Trials in which a time-out came first"},
       [](const S& row) { return field(row.curve.censored); }},
      of_median("median_s", "Median time by Kaplan and Meier; empty if half were never reached",
                [](const Median& median) { return std::optional(median.value); }),
      of_median("median_ci95_low_s", "Lower end of its 95 % interval, trials taken as independent",
                [](const Median& median) { return median.low; }),
      of_median("median_ci95_high_s", "Upper end; empty if there is none",
                [](const Median& median) { return median.high; }),
      of_mean("restricted_mean_s", "Mean of the times, each cut off at horizon_s",
              [](const RestrictedMean& mean) { return mean.mean; }),
      of_mean("restricted_mean_se_s", "Its standard error, trials taken as independent",
              [](const RestrictedMean& mean) { return mean.standard_error; }),
      of_mean("horizon_s",
              "Earliest right-censored time of any method, or else the longest time of the mark",
              [](const RestrictedMean& mean) { return mean.horizon; }),
      kind_of_all<S>(tables)};
  return tabulate("time_to_mark", "mark and method", columns, tables.survival);
}

PrintedTable printed_time_to_mark(const StudyTables& tables) {
  PrintedTable table;
  table.id = "time-to-mark";
  table.title = "Time to each mark, with trials in which it was never reached.";
  table.note =
      "Kaplan and Meier’s estimate over trials; restricted means are of times cut off at the "
      "horizon. They describe these trials: intervals take them as independent, which those of one "
      "participant are not.";
  table.columns = {"Mark, method",       "trials",    "not reached", "median, s [95 %]",
                   "restricted mean, s", "horizon, s"};
  for (const MarkSurvival& row : tables.survival) {
    table.rows.push_back({fmt::format("{}, {}", row.mark, method_label(row.method)),
                          std::to_string(row.curve.n), std::to_string(row.curve.censored),
                          median_text(row.curve),
                          row.restricted ? fixed(row.restricted->mean, 1) : "–",
                          row.restricted ? fixed(row.restricted->horizon, 1) : "–"});
  }
  return table;
}

std::string survival_figure_name(const Measure& mark) { return "time_to_" + mark.id(); }

std::optional<Figure> survival_figure(const StudyTables& tables, std::size_t mark) {
  const std::size_t methods = tables.set.methods.size();
  const auto curve_of = [&](std::size_t method) -> const SurvivalCurve& {
    return tables.survival.at(mark * methods + method).curve;
  };
  std::vector<double> ends;
  for (std::size_t method = 0; method < methods; ++method) {
    const std::vector<SurvivalStep>& steps = curve_of(method).steps;
    if (!steps.empty()) {
      ends.insert(ends.end(), {steps.front().time, steps.back().time});
    }
  }
  const std::optional<Interval> range = reach_of(ends, {});
  if (!range || range->low <= 0.0) {
    return std::nullopt;
  }
  std::string data;
  std::vector<std::string> layers;
  for (std::size_t method = 0; method < methods; ++method) {
    const SurvivalCurve& curve = curve_of(method);
    if (curve.steps.empty()) {
      continue;
    }
    const std::string_view color = method_color(method).rgb;
    data += curve_data(curve, method, range->low);
    layers.push_back(fmt::format(
        "$method{} using 1:2 with steps linewidth 2 dashtype {} linecolor rgb '{}' title {}",
        method, 1 + method % 5, color, gnuplot_quoted(method_label(tables.set.methods[method]))));
    if (curve.censored > 0) {
      data += censored_data(curve, method);
      layers.push_back(fmt::format(
          "$censored{} using 1:2 with points pointtype 1 linewidth 1.5 linecolor rgb '{}' notitle",
          method, color));
    }
  }
  return drawn_figure(
      survival_figure_name(tables.set.measures[mark]), figure_width, 320,
      figure_preamble(tables) + logarithmic_axis(*range) +
          fmt::format("set yrange [0:1.02]\nset xlabel 'Time, seconds (logarithmic)'\n"
                      "set ylabel 'Trials without the mark' textcolor rgb '{}'\n"
                      "set format y '%.1f'\n"
                      "set key outside top right horizontal Left reverse samplen 2.5 width 1\n"
                      "set grid ytics linetype 1 linewidth 1 linecolor rgb '{}'\n",
                      palette::ink.rgb, palette::grid.rgb) +
          data + fmt::format("plot {}\n", fmt::join(layers, ", \\\n")));
}

}  // namespace foveola::analysis
