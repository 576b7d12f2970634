#include "analysis/publication/time_figures.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_drawing.h"
#include "analysis/publication/figure_palette.h"
#include "analysis/publication/gnuplot.h"

namespace foveola::analysis {
namespace {

/// Seconds, or per cent of the baseline.
struct TimeScale {
  std::vector<double> MethodTimes::*participants;
  std::optional<Estimate> MethodTimes::*estimate;
};

/// How far a mark's points lie beside their row, so that those of several marks do not cover each
/// other; `index` counts the `marks` marks.
double beside_row(std::size_t index, std::size_t marks) {
  const double step = std::min(0.34, 0.8 / static_cast<double>(marks));
  return (static_cast<double>(index) - 0.5 * static_cast<double>(marks - 1)) * step;
}

/// The two data blocks of one mark: $markN_participants (x, y) and $markN (x, low, high, y).
std::string time_data(const StudyTables& tables, std::size_t mark,
                      const std::vector<std::size_t>& methods, const TimeScale& scale) {
  std::string dots = fmt::format("$mark{}_participants << END\n", mark);
  std::string estimates = fmt::format("$mark{} << END\n", mark);
  const double offset = beside_row(mark, tables.set.times().size());
  for (std::size_t row = 0; row < methods.size(); ++row) {
    const MethodTimes& times = tables.method_times_of(mark, methods[row]);
    const double y = static_cast<double>(row) + offset;
    const std::vector<double>& values = times.*scale.participants;
    for (std::size_t i = 0; values.size() <= most_dots && i < values.size(); ++i) {
      dots += fmt::format("{} {}\n", values[i], y);
    }
    if (const auto& estimate = times.*scale.estimate) {
      const Interval interval =
          estimate->interval.value_or(Interval{estimate->value, estimate->value});
      estimates += fmt::format("{} {} {} {}\n", estimate->value, interval.low, interval.high, y);
    }
  }
  return dots + "END\n" + estimates + "END\n";
}

/// Discs, squares, triangles and so on, so that marks differ by more than their colours: first all
/// participants, then the estimates upon them.
std::string time_plot(const StudyTables& tables) {
  constexpr std::array hollow = {6, 4, 8, 10, 12, 14};
  constexpr std::array filled = {7, 5, 9, 11, 13, 15};
  std::vector<std::string> layers;
  for (const std::size_t mark : tables.set.times()) {
    layers.push_back(fmt::format(
        "$mark{}_participants using 1:2 with points pointtype {} pointsize 0.55 linecolor rgb '{}' "
        "notitle",
        mark, hollow[mark % hollow.size()], palette::marks[mark % palette::marks.size()].rgb));
  }
  for (const std::size_t mark : tables.set.times()) {
    layers.push_back(fmt::format(
        "$mark{} using 1:4:2:3 with xerrorbars pointtype {} pointsize 0.9 linewidth 2 "
        "linecolor rgb '{}' title {}",
        mark, filled[mark % filled.size()], palette::marks[mark % palette::marks.size()].rgb,
        gnuplot_quoted(tables.set.measures[mark].id())));
  }
  return fmt::format("plot {}\n", fmt::join(layers, ", \\\n"));
}

/// How far a time figure's axis reaches: over every participant's value, and over an interval only
/// up to a multiple of these, so that the interval of a few participants does not hide the rest.
std::optional<Interval> axis_range(const StudyTables& tables, const TimeScale& scale) {
  constexpr double farthest = 2.5;
  std::vector<double> values;
  std::vector<double> ends;
  for (const MethodTimes& times : tables.method_times) {
    const std::vector<double>& participants = times.*scale.participants;
    values.insert(values.end(), participants.begin(), participants.end());
    if (const auto& estimate = times.*scale.estimate; estimate && estimate->interval) {
      ends.insert(ends.end(), {estimate->interval->low, estimate->interval->high});
    }
  }
  if (values.empty()) {
    return std::nullopt;
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  Interval range{*low, *high};
  for (const double end : ends) {
    range.low = std::min(range.low, std::max(end, *low / farthest));
    range.high = std::max(range.high, std::min(end, *high * farthest));
  }
  return range;
}

Figure time_figure(const std::string& name, const StudyTables& tables,
                   const std::vector<std::size_t>& methods, const TimeScale& scale,
                   const std::string& axis) {
  std::vector<std::string> names;
  std::transform(methods.begin(), methods.end(), std::back_inserter(names),
                 [&](std::size_t method) { return tables.set.methods[method]; });
  const int per_method = std::max(62, 31 * static_cast<int>(tables.set.times().size()));
  const int height = 110 + per_method * static_cast<int>(methods.size());
  std::string data;
  for (const std::size_t mark : tables.set.times()) {
    data += time_data(tables, mark, methods, scale);
  }
  return drawn_figure(
      name, 640, height,
      figure_preamble(tables) + row_names(names) +
          "set key outside top right horizontal Left reverse samplen 1.5 width 1\n" + axis +
          fmt::format("set grid xtics linetype 1 linewidth 1 linecolor rgb '{}'\n",
                      palette::grid.rgb) +
          data + time_plot(tables));
}

}  // namespace

std::optional<Figure> relative_figure(const StudyTables& tables) {
  const TimeScale scale{&MethodTimes::participant_percent, &MethodTimes::percent_of_baseline};
  const std::optional<Interval> range = axis_range(tables, scale);
  if (!range) {
    return std::nullopt;
  }
  std::vector<std::size_t> methods;
  for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
    methods.push_back(method);
  }
  const double end = std::max(105.0, 1.05 * range->high);
  const std::string axis = fmt::format(
      "set xrange [0:{}]\nset xlabel {}\n"
      "set arrow from 100, graph 0 to 100, graph 1 nohead linewidth 1 linecolor rgb "
      "'{}'\n",
      end, gnuplot_quoted("Time, per cent of " + method_label(tables.set.methods[baseline]) + "’s"),
      palette::ink.rgb);
  return time_figure("relative_times", tables, methods, scale, axis);
}

std::optional<Figure> seconds_figure(const StudyTables& tables) {
  const TimeScale scale{&MethodTimes::participant_seconds, &MethodTimes::seconds};
  const std::optional<Interval> range = axis_range(tables, scale);
  if (!range) {
    return std::nullopt;
  }
  std::vector<std::size_t> methods(tables.set.methods.size());
  std::iota(methods.begin(), methods.end(), std::size_t{0});
  const std::string axis = fmt::format(
      "set logscale x\nset xrange [{}:{}]\nset xlabel 'Time, seconds (logarithmic)'\n"
      "set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, "
      "2000, 5000)\n",
      range->low / 1.25, range->high * 1.25);
  return time_figure("times_in_seconds", tables, methods, scale, axis);
}

}  // namespace foveola::analysis
