#include "analysis/publication/grouped_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/publication/gnuplot.h"

namespace foveola::analysis {

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
