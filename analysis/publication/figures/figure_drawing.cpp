#include "analysis/publication/figures/figure_drawing.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

constexpr double interval_width = 2.5;

int filled_point(std::size_t method) { return hollow_point(method) + 1; }

/// Writes into a figure's corner whose data it shows, so that a copied file says so too.
std::string data_mark(const StudyTables& tables) {
  const std::string notice = data_notice(tables);
  return notice.empty() ? ""
                        : fmt::format(
                              "set label {} at screen 0.012, screen 1 offset 0,-0.7 left "
                              "front textcolor rgb '{}'\n",
                              gnuplot_quoted(notice), palette::ink.rgb);
}

}  // namespace

std::string figure_preamble(const StudyTables& tables) {
  return fmt::format(
             "set encoding utf8\n"
             "set border 1 linecolor rgb '{}'\n"
             "set tics out nomirror textcolor rgb '{}'\n"
             "set xlabel textcolor rgb '{}'\n"
             "set key textcolor rgb '{}'\n"
             "set ytics scale 0\n",
             palette::ink.rgb, palette::ink.rgb, palette::ink.rgb, palette::ink.rgb) +
         data_mark(tables);
}

std::string row_names(const std::vector<std::string>& methods) {
  std::string tics;
  for (std::size_t row = 0; row < methods.size(); ++row) {
    tics += fmt::format("{}{} {}", row > 0 ? ", " : "",
                        gnuplot_tick_label(method_label(methods[row])), row);
  }
  return fmt::format("set ytics ({})\nset yrange [{}:-0.6]\n", tics,
                     static_cast<double>(methods.size()) - 0.4);
}

std::vector<std::string> ids_of(const StudyTables& tables, const std::vector<std::size_t>& marks) {
  std::vector<std::string> ids;
  for (const std::size_t mark : marks) {
    ids.push_back(tables.set.measures[mark].id());
  }
  return ids;
}

// Discs, squares, triangles and so on.
int hollow_point(std::size_t method) {
  constexpr std::array types = {6, 4, 8, 10, 12, 14};
  return types[method % types.size()];
}

const FigureColor& method_color(std::size_t method) {
  return palette::methods[method % palette::methods.size()];
}

std::string estimate_line(const Estimate& estimate, double y) {
  const Interval interval = estimate.interval.value_or(Interval{estimate.value, estimate.value});
  return fmt::format("{} {} {} {}\n", estimate.value, interval.low, interval.high, y);
}

std::string estimates_layer(const std::string& block, std::size_t method) {
  return fmt::format(
      "{} using 1:4:2:3 with xerrorbars pointtype {} pointsize 1 linewidth {} linecolor rgb '{}' "
      "notitle",
      block, filled_point(method), interval_width, method_color(method).rgb);
}

std::string hollow_estimates_layer(const std::string& block, std::size_t method) {
  const std::string inside =
      fmt::format("{} using 1:4 with points pointtype {} pointsize 0.8 linecolor rgb '{}' notitle",
                  block, filled_point(method), palette::paper.rgb);
  const std::string edge = fmt::format(
      "{} using 1:4 with points pointtype {} pointsize 1 linewidth 1.5 linecolor rgb '{}' notitle",
      block, hollow_point(method), method_color(method).rgb);
  return fmt::format("{}, \\\n{}, \\\n{}", estimates_layer(block, method), inside, edge);
}

std::string method_key(const StudyTables& tables, std::size_t method) {
  return fmt::format(
      "keyentry with linespoints pointtype {} pointsize 1 linewidth {} linecolor rgb '{}' title {}",
      filled_point(method), interval_width, method_color(method).rgb,
      gnuplot_quoted(method_label(tables.set.methods[method])));
}

std::string horizontal_rule(double y, const FigureColor& color) {
  return fmt::format(
      "set arrow from graph 0, first {0} to graph 1, first {0} nohead linewidth 1 linecolor rgb "
      "'{1}'\n",
      y, color.rgb);
}

std::string row_axis(const GroupedRows& rows) {
  std::vector<std::string> names;
  std::string headings;
  for (std::size_t group = 0; group < rows.headings.size(); ++group) {
    const double top = rows.group_height() * static_cast<double>(group);
    headings += fmt::format(
        "set label {} at graph 0, first {} offset 0.4,0 left front textcolor rgb '{}'\n",
        gnuplot_quoted(rows.headings[group]), top + 0.5 * rows.heading_height, palette::ink.rgb);
    if (group > 0) {
      headings += horizontal_rule(top, palette::ink);
    }
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      names.push_back(fmt::format("{} {}", gnuplot_tick_label(rows.rows[row]), rows.y(group, row)));
    }
  }
  return fmt::format("set ytics ({})\nset yrange [{}:0]\n", fmt::join(names, ", "), rows.height()) +
         headings;
}

}  // namespace foveola::analysis
