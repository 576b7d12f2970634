#include "analysis/publication/figures/scene_figure.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/figures/figure_drawing.h"
#include "analysis/publication/figures/logarithmic_axis.h"

namespace foveola::analysis {
namespace {

constexpr double line_height = 17.0;  // Of one method in a row, in SVG units.

bool has_censored(const StudyTables& tables, std::size_t mark, std::size_t scene,
                  std::size_t method) {
  return tables.scene_times_of(mark, scene, method).censored > 0;
}

/// A method's ratio to the baseline in one row of the figure.
struct SceneRatio {
  std::optional<Estimate> percent;
  bool lacks_censored = false;  ///< Whether a right-censored time is not in it.
};

SceneRatio ratio_in_scene(const StudyTables& tables, std::size_t mark, std::size_t scene,
                          std::size_t method) {
  return {tables.scene_times_of(mark, scene, method).geometric_percent,
          has_censored(tables, mark, scene, baseline) || has_censored(tables, mark, scene, method)};
}

/// A scene counts only if every method was measured: any method's censored time removes it.
SceneRatio ratio_in_all_scenes(const StudyTables& tables, std::size_t mark, std::size_t method) {
  SceneRatio ratio{tables.method_times_of(mark, method).percent_of_baseline};
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    for (std::size_t any = 0; any < tables.set.methods.size(); ++any) {
      ratio.lacks_censored = ratio.lacks_censored || has_censored(tables, mark, scene, any);
    }
  }
  return ratio;
}

/// Rows of the figure: every scene of each mark, and all scenes together if there are several. A
/// row's methods are below one another.
struct SceneRows {
  const StudyTables& tables;
  std::vector<std::size_t> marks;  ///< Of each group of rows.
  GroupedRows rows;

  std::size_t methods() const { return tables.set.methods.size() - 1; }
  double row_height() const {  ///< In SVG units.
    constexpr double margin = 10.0;
    return margin + line_height * static_cast<double>(methods());
  }
  SceneRatio ratio(std::size_t group, std::size_t row, std::size_t method) const {
    return row < tables.set.scenes.size() ? ratio_in_scene(tables, marks[group], row, method)
                                          : ratio_in_all_scenes(tables, marks[group], method);
  }
  double y(std::size_t group, std::size_t row, std::size_t method) const {
    const double line = static_cast<double>(method - baseline - 1);
    const double from_middle = line - 0.5 * static_cast<double>(methods() - 1);
    return rows.y(group, row) + from_middle * line_height / row_height();
  }
};

SceneRows scene_rows(const StudyTables& tables) {
  SceneRows drawn{tables, marks_in_scenes(tables), {}};
  drawn.rows = {ids_of(tables, drawn.marks), tables.set.scenes, 24.0 / drawn.row_height()};
  if (tables.set.scenes.size() > 1) {
    drawn.rows.rows.emplace_back("all scenes");
  }
  return drawn;
}

std::optional<Interval> range_of(const SceneRows& drawn) {
  std::vector<double> values;
  std::vector<Interval> intervals;
  for (std::size_t group = 0; group < drawn.marks.size(); ++group) {
    for (std::size_t row = 0; row < drawn.rows.rows.size(); ++row) {
      for (std::size_t method = baseline + 1; method <= drawn.methods(); ++method) {
        if (const auto percent = drawn.ratio(group, row, method).percent) {
          values.push_back(percent->value);
          intervals.push_back(percent->interval.value_or(Interval{percent->value, percent->value}));
        }
      }
    }
  }
  return reach_of(values, intervals);
}

/// Returns one method's data blocks, $ratios_METHOD and $hollow_ratios_METHOD (which leaves out
/// censored times), and the numbers of pairs beside the rows.
std::string method_data(const SceneRows& drawn, std::size_t method) {
  std::string filled;
  std::string hollow;
  std::string counts;
  for (std::size_t group = 0; group < drawn.marks.size(); ++group) {
    for (std::size_t row = 0; row < drawn.rows.rows.size(); ++row) {
      const SceneRatio ratio = drawn.ratio(group, row, method);
      const double y = drawn.y(group, row, method);
      if (ratio.percent) {
        (ratio.lacks_censored ? hollow : filled) += estimate_line(*ratio.percent, y);
      }
      counts += fmt::format("set label '{}' at graph 1.02, first {} left textcolor rgb '{}'\n",
                            ratio.percent ? ratio.percent->n : 0, y, palette::ink.rgb);
    }
  }
  return fmt::format("$ratios_{0} << END\n{1}END\n$hollow_ratios_{0} << END\n{2}END\n{3}", method,
                     filled, hollow, counts);
}

std::string rules_above_all_scenes(const SceneRows& drawn) {
  std::string rules;
  const std::size_t scenes = drawn.tables.set.scenes.size();
  for (std::size_t group = 0; scenes > 1 && group < drawn.marks.size(); ++group) {
    rules += horizontal_rule(drawn.rows.y(group, scenes) - 0.5, palette::grid);
  }
  return rules;
}

}  // namespace

std::vector<std::size_t> marks_in_scenes(const StudyTables& tables) {
  std::vector<std::size_t> marks;
  for (const std::size_t mark : tables.set.times()) {
    if (std::ranges::any_of(tables.scene_times, [&](const SceneTimes& times) {
          return times.mark == tables.set.measures[mark].id() && times.geometric_percent;
        })) {
      marks.push_back(mark);
    }
  }
  return marks;
}

bool lacks_censored_times(const StudyTables& tables) {
  const std::vector<std::size_t> marks = marks_in_scenes(tables);
  return std::ranges::any_of(tables.scene_times, [&](const SceneTimes& times) {
    return times.censored > 0 && std::ranges::any_of(marks, [&](std::size_t mark) {
             return tables.set.measures[mark].id() == times.mark;
           });
  });
}

std::optional<Figure> relative_scene_figure(const StudyTables& tables) {
  const SceneRows drawn = scene_rows(tables);
  const std::optional<Interval> range = range_of(drawn);
  if (!range) {
    return std::nullopt;
  }
  std::string data =
      fmt::format("set label 'n' at graph 1.02, graph 1 offset 0,-0.6 left textcolor rgb '{}'\n",
                  palette::ink.rgb);
  std::vector<std::string> layers;
  for (std::size_t method = baseline + 1; method <= drawn.methods(); ++method) {
    data += method_data(drawn, method);
    layers.push_back(estimates_layer(fmt::format("$ratios_{}", method), method));
    layers.push_back(hollow_estimates_layer(fmt::format("$hollow_ratios_{}", method), method));
    layers.push_back(method_key(tables, method));
  }
  constexpr int key_height = 24;
  const int height = lower_axis_height + upper_axis_height + key_height +
                     static_cast<int>(drawn.row_height() * drawn.rows.height());
  return drawn_figure(
      "relative_times_by_scene", figure_width, height,
      figure_preamble(tables) + row_axis(drawn.rows) +
          relative_axes(with_no_change(*range), method_label(tables.set.methods[baseline])) +
          "set key outside top right horizontal Left reverse samplen 1.5 width 1\nset rmargin 6\n" +
          rules_above_all_scenes(drawn) + data +
          fmt::format("plot {}\n", fmt::join(layers, ", \\\n")));
}

}  // namespace foveola::analysis
