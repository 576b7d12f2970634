#include "analysis/publication/figures/time_figures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figures/figure_drawing.h"
#include "analysis/publication/figures/logarithmic_axis.h"
#include "analysis/publication/figures/participant_points.h"

namespace foveola::analysis {
namespace {

/// Seconds, or per cent of the baseline.
struct TimeScale {
  std::vector<double> MethodTimes::* participants;
  std::optional<Estimate> MethodTimes::* estimate;
  std::size_t first_method = 0;  ///< The methods from this one on are drawn.
};

/// Rows of a figure with one row per method, and the places of its participants' points.
struct MethodRows {
  const StudyTables& tables;
  TimeScale scale;
  Interval range;  ///< Of the axis.
  bool has_points = false;
  std::vector<std::size_t> marks;  ///< Of each group of rows: those that have values.
  GroupedRows rows;

  double row_height() const { return has_points ? 64.0 : 32.0; }  ///< In SVG units.
  const MethodTimes& times(std::size_t group, std::size_t row) const {
    return tables.method_times_of(marks[group], scale.first_method + row);
  }
  /// Places estimates above the participants' points, which would hide them.
  double estimate_y(std::size_t group, std::size_t row) const {
    return rows.y(group, row) - (has_points ? 0.32 : 0.0);
  }
};

/// Returns, for every mark, the points of all methods, which are of the same participants.
std::vector<JoinedPoints> participant_points(const MethodRows& drawn) {
  constexpr double below_estimate = 0.08;
  std::vector<JoinedPoints> groups(drawn.marks.size());
  for (std::size_t group = 0; group < groups.size(); ++group) {
    for (std::size_t row = 0; row < drawn.rows.rows.size(); ++row) {
      const std::vector<double>& values = drawn.times(group, row).*drawn.scale.participants;
      std::vector<double> places;
      for (const double value : values) {
        places.push_back(std::log(value / drawn.range.low) /
                         std::log(drawn.range.high / drawn.range.low));
      }
      groups[group].push_back(points_in_row(drawn.scale.first_method + row, values, places,
                                            drawn.rows.y(group, row) + below_estimate,
                                            drawn.row_height()));
    }
  }
  return groups;
}

std::string estimate_data(const MethodRows& drawn) {
  std::string data;
  for (std::size_t row = 0; row < drawn.rows.rows.size(); ++row) {
    data += fmt::format("$estimates_{} << END\n", drawn.scale.first_method + row);
    for (std::size_t group = 0; group < drawn.marks.size(); ++group) {
      if (const auto& estimate = drawn.times(group, row).*drawn.scale.estimate) {
        data += estimate_line(*estimate, drawn.estimate_y(group, row));
      }
    }
    data += "END\n";
  }
  return data;
}

std::string method_rows_plot(const MethodRows& drawn) {
  std::vector<std::string> layers;
  if (drawn.has_points) {
    layers = participant_layers(drawn.tables, drawn.scale.first_method);
  }
  const std::size_t methods = drawn.tables.set.methods.size();
  for (std::size_t method = drawn.scale.first_method; method < methods; ++method) {
    layers.push_back(estimates_layer(fmt::format("$estimates_{}", method), method));
  }
  return fmt::format("unset key\nplot {}\n", fmt::join(layers, ", \\\n"));
}

Figure method_rows_figure(const std::string& name, const MethodRows& drawn, const std::string& axes,
                          int axes_height) {
  const int height = axes_height + static_cast<int>(drawn.row_height() * drawn.rows.height());
  return drawn_figure(name, figure_width, height,
                      figure_preamble(drawn.tables) + row_axis(drawn.rows) + axes +
                          (drawn.has_points ? participant_data(participant_points(drawn)) : "") +
                          estimate_data(drawn) + method_rows_plot(drawn));
}

std::optional<Interval> range_of(const StudyTables& tables, const TimeScale& scale) {
  std::vector<double> values;
  std::vector<Interval> intervals;
  for (const MethodTimes& times : tables.method_times) {
    const std::vector<double>& participants = times.*scale.participants;
    if (draws_participants(tables)) {
      values.insert(values.end(), participants.begin(), participants.end());
    }
    if (const auto& estimate = times.*scale.estimate) {
      values.push_back(estimate->value);
      intervals.push_back(estimate->interval.value_or(Interval{estimate->value, estimate->value}));
    }
  }
  return reach_of(values, intervals);
}

std::optional<MethodRows> method_rows(const StudyTables& tables, const TimeScale& scale) {
  const std::optional<Interval> range = range_of(tables, scale);
  if (!range) {
    return std::nullopt;
  }
  MethodRows drawn{tables, scale, *range, draws_participants(tables), {}, {}};
  drawn.marks = marks_over_all_scenes(tables);
  drawn.rows.headings = ids_of(tables, drawn.marks);
  for (std::size_t method = scale.first_method; method < tables.set.methods.size(); ++method) {
    drawn.rows.rows.push_back(method_label(tables.set.methods[method]));
  }
  drawn.rows.heading_height = 26.0 / drawn.row_height();
  return drawn;
}

/// Returns the curve as points of (time, share without a mark), from `start` on. Thousands of steps
/// are thinned to the visible ones.
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

std::string censored_data(const SurvivalCurve& curve, std::size_t method) {
  std::string data = fmt::format("$censored{} << END\n", method);
  for (const SurvivalStep& step : curve.steps) {
    data += step.censored > 0 ? fmt::format("{} {}\n", step.time, step.survival) : "";
  }
  return data + "END\n";
}

}  // namespace

std::vector<std::size_t> marks_over_all_scenes(const StudyTables& tables) {
  std::vector<std::size_t> marks = tables.set.times();
  marks.erase(std::remove_if(marks.begin(), marks.end(),
                             [&](std::size_t mark) {
                               return !tables.method_times_of(mark, baseline).seconds;
                             }),
              marks.end());
  return marks;
}

std::optional<Figure> relative_figure(const StudyTables& tables) {
  std::optional<MethodRows> drawn = method_rows(
      tables, {&MethodTimes::participant_percent, &MethodTimes::percent_of_baseline, baseline + 1});
  if (!drawn) {
    return std::nullopt;
  }
  drawn->range = with_no_change(drawn->range);
  return method_rows_figure("relative_times", *drawn,
                            relative_axes(drawn->range, method_label(tables.set.methods[baseline])),
                            lower_axis_height + upper_axis_height);
}

std::optional<Figure> seconds_figure(const StudyTables& tables) {
  const std::optional<MethodRows> drawn =
      method_rows(tables, {&MethodTimes::participant_seconds, &MethodTimes::seconds});
  if (!drawn) {
    return std::nullopt;
  }
  return method_rows_figure(
      "times_in_seconds", *drawn,
      logarithmic_axis(drawn->range) + "set xlabel 'Time, seconds (logarithmic)'\nset tmargin 2\n",
      lower_axis_height + 24);
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
