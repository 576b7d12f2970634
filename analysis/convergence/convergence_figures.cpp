#include "analysis/convergence/convergence_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

namespace foveola::analysis {
namespace {

struct FigureKind {
  std::string_view region;
  Metric metric;
  std::string_view file;
  std::string_view axis;
};
constexpr std::array kinds = {
    FigureKind{"5deg", Metric::mse, "rmse-5deg", "RMSE within 5 degrees"},
    FigureKind{"viewport", Metric::mse, "rmse-viewport", "RMSE in the viewport"},
    FigureKind{"sphere", Metric::mse, "rmse-sphere", "RMSE over the sphere"},
    FigureKind{"viewport", Metric::flip, "flip-viewport", "FLIP in the viewport"}};

/// Colours that are distinct with colour-vision deficiencies too (Okabe and Ito 2008, "Color
/// Universal Design").
constexpr std::array line_colors = {"#000000", "#0072b2", "#d55e00", "#009e73",
                                    "#cc79a7", "#e69f00", "#56b4e9"};
/// Symbols that are distinct without colours: gnuplot's disc, square, triangles, diamond and their
/// outlines.
constexpr std::array point_types = {7, 5, 9, 11, 13, 6, 4};

/// Returns the drawn value of an error: the root of mean squared errors.
double drawn(Metric metric, double error) {
  return metric == Metric::mse ? std::sqrt(error) : error;
}

struct Line {
  std::string name;
  ErrorCurve curve;
};

/// Returns no lines if the region was not measured.
std::vector<Line> lines_of(const GazeMeasurement& measurement, const FigureKind& kind) {
  const auto region = std::ranges::find(measurement.regions, kind.region);
  if (region == measurement.regions.end()) {
    return {};
  }
  std::vector<std::size_t> repetitions(measurement.repetitions.size());
  std::iota(repetitions.begin(), repetitions.end(), std::size_t{0});
  std::vector<Line> lines;
  for (std::size_t i = 0; i < measurement.configurations.size(); ++i) {
    const CurveSource source{
        .configuration = i,
        .region = static_cast<std::size_t>(region - measurement.regions.begin()),
        .metric = kind.metric};
    lines.push_back({measurement.configurations[i], mean_curve(measurement, source, repetitions)});
  }
  return lines;
}

std::string data_of(const std::vector<Line>& lines, Metric metric) {
  std::string data;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    data += fmt::format("$line{} << END\n", i);
    for (const CurvePoint& point : lines[i].curve) {
      data += fmt::format("{} {} {}\n", point.samples, point.seconds, drawn(metric, point.error));
    }
    data += "END\n";
  }
  return data;
}

/// Returns "fv, slope -0.53".
std::string title_of(const Line& line, Metric metric, Axis axis) {
  const std::optional<double> slope = log_log_slope(line.curve, axis);
  const double root = metric == Metric::mse ? 0.5 : 1.0;
  return slope ? fmt::format("{}, slope {:.2f}", line.name, root * *slope) : line.name;
}

std::string panel(const std::vector<Line>& lines, const FigureKind& kind, Axis axis) {
  std::string plot =
      fmt::format("set xlabel {}\nset ylabel {}\nplot ",
                  axis == Axis::samples ? "'Samples'" : "'Seconds'", gnuplot_quoted(kind.axis));
  bool is_first = true;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].curve.empty()) {
      plot += fmt::format(
          "{}$line{} using {}:3 with linespoints pointtype {} pointsize 0.6 linewidth 2 "
          "linecolor rgb '{}' title {}",
          is_first ? "" : ", \\\n", i, axis == Axis::samples ? 1 : 2,
          point_types[i % point_types.size()], line_colors[i % line_colors.size()],
          gnuplot_quoted(title_of(lines[i], kind.metric, axis)));
      is_first = false;
    }
  }
  return plot + "\n";
}

std::string script(const std::vector<Line>& lines, const GazeMeasurement& measurement,
                   const FigureKind& kind) {
  return fmt::format(
             "set terminal svg size 1000,460 dynamic noenhanced font 'sans-serif,14' background "
             "'white'\n"
             "set encoding utf8\n"
             "set border 3 linecolor rgb '{0}'\n"
             "set tics out nomirror textcolor rgb '{0}'\n"
             "set grid linetype 1 linewidth 1 linecolor rgb '{1}'\n"
             "set logscale xy\nset format x '%.0s%c'\nset format y '%.2g'\n"
             "set key bottom left Left reverse samplen 1.5\n",
             palette::ink.rgb, palette::grid.rgb) +
         data_of(lines, kind.metric) +
         fmt::format(
             "set multiplot layout 1,2 title {}\n",
             gnuplot_quoted(fmt::format("{}, gaze {}", measurement.scene, measurement.gaze))) +
         panel(lines, kind, Axis::samples) + "set format x '%g'\n" +
         panel(lines, kind, Axis::seconds) + "unset multiplot\n";
}

}  // namespace

std::vector<Figure> draw_convergence(const std::vector<GazeMeasurement>& measurements) {
  std::vector<Figure> figures;
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    for (const FigureKind& kind : kinds) {
      const std::vector<Line> lines = lines_of(measurements[i], kind);
      const bool has_points =
          std::ranges::any_of(lines, [](const Line& l) { return !l.curve.empty(); });
      if (has_points) {
        figures.push_back({fmt::format("error-{}-{}", i + 1, kind.file),
                           run_gnuplot(script(lines, measurements[i], kind))});
      }
    }
  }
  return figures;
}

}  // namespace foveola::analysis
