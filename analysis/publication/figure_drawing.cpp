#include "analysis/publication/figure_drawing.h"

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_palette.h"
#include "analysis/publication/gnuplot.h"

namespace foveola::analysis {
namespace {

/// Writes whose data a figure shows into its corner, so that the file says so wherever it goes.
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
    tics += fmt::format("{}{} {}", row > 0 ? ", " : "", gnuplot_quoted(method_label(methods[row])),
                        row);
  }
  return fmt::format("set ytics ({})\nset yrange [{}:-0.6]\n", tics,
                     static_cast<double>(methods.size()) - 0.4);
}

Figure drawn_figure(const std::string& name, int width, int height, const std::string& script) {
  const std::string terminal = fmt::format(
      "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,14' background 'white'\n",
      width, height);
  return {name, run_gnuplot(terminal + script), width, height, script};
}

}  // namespace foveola::analysis
