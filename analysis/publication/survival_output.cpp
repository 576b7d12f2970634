#include "analysis/publication/survival_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_drawing.h"
#include "analysis/publication/logarithmic_axis.h"
#include "analysis/publication/result_tables.h"
#include "analysis/tables/row_text.h"

namespace foveola::analysis {
namespace {

/// The curve as points of (time, share without a mark), from `start` on; of thousands of steps only
/// so many as can be seen.
std::string curve_data(const SurvivalCurve& curve, std::size_t method, double start) {
  std::string data = fmt::format("$method{} << END\n{} 1\n", method, start);
  constexpr std::size_t max_steps = 1000;
  const std::size_t stride = 1 + curve.steps.size() / max_steps;
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
  const auto median = path(&S::curve, &SurvivalCurve::median);
  const ColumnsOf<S> columns = {
      {"mark", "", "Id of the mark", &S::mark},
      {"method", "", "Id of the method", &S::method},
      {"trials", "", "Trials with a time or a right-censored one",
       path(&S::curve, &SurvivalCurve::n)},
      {"reached", "", "Trials in which the mark was reached",
       path(&S::curve, &SurvivalCurve::events)},
      {"right_censored", "", "Trials in which a time-out came first",
       path(&S::curve, &SurvivalCurve::censored)},
      {"median_s", "s", "Median time by Kaplan and Meier; empty if half were never reached",
       path(median, &SurvivalMedian::value)},
      {"median_ci95_low_s", "s", "Lower end of its 95 % interval, trials taken as independent",
       path(median, &SurvivalMedian::low)},
      {"median_ci95_high_s", "s", "Upper end; empty if there is none",
       path(median, &SurvivalMedian::high)},
      {"restricted_mean_s", "s", "Mean of the times, each cut off at horizon_s",
       path(&S::restricted, &RestrictedMean::mean)},
      {"restricted_mean_se_s", "s", "Its standard error, trials taken as independent",
       path(&S::restricted, &RestrictedMean::standard_error)},
      {"horizon_s", "s",
       "Earliest right-censored time of any method, or else the longest time of the mark",
       path(&S::restricted, &RestrictedMean::horizon)},
      kind_of_all<S>(tables)};
  return tabulate("time_to_mark", "mark and method", columns, tables.survival);
}

PrintedTable printed_time_to_mark(const Table& time_to_mark) {
  return print_rows(
      {.id = "time-to-mark",
       .title = "Time to each mark, with trials in which it was never reached.",
       .note = "Kaplan and Meier’s estimate over trials; restricted means are of times cut off at "
               "the horizon. They describe these trials: intervals take them as independent, which "
               "those of one participant are not."},
      with_method_labels(time_to_mark), "",
      {{"Mark, method", "{mark}, {method}"},
       {"trials", "{trials}"},
       {"not reached", "{right_censored}"},
       {"median, s [95 %]", "{median_s:.1} [{median_ci95_low_s:.1}, {median_ci95_high_s:.1}]",
        "{median_s:.1} [{median_ci95_low_s:.1}, ∞]", "{median_s:.1} [–, {median_ci95_high_s:.1}]",
        "{median_s:.1} [–, ∞]", "not reached"},
       {"restricted mean, s", "{restricted_mean_s:.1}"},
       {"horizon, s", "{horizon_s:.1}"}});
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
