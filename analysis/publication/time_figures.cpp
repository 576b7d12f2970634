#include "analysis/publication/time_figures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_drawing.h"
#include "analysis/publication/logarithmic_axis.h"
#include "analysis/publication/participant_points.h"

namespace foveola::analysis {
namespace {

/// Seconds, or per cent of the baseline.
struct TimeScale {
  std::vector<double> MethodTimes::* participants;
  std::optional<Estimate> MethodTimes::* estimate;
  std::size_t first_method = 0;  ///< The methods from this one on are drawn.
};

/// The rows of a figure in which each method has one, and where its participants' points are.
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
  /// Above the participants' points, which would hide it.
  double estimate_y(std::size_t group, std::size_t row) const {
    return rows.y(group, row) - (has_points ? 0.32 : 0.0);
  }
};

/// Of every mark the points of all methods, which are of the same participants.
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

/// The lines below the points below the estimates.
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

}  // namespace foveola::analysis
