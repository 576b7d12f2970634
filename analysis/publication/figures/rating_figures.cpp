#include "analysis/publication/figures/rating_figures.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/wording.h"
#include "analysis/publication/figures/figure_drawing.h"
#include "analysis/publication/figures/participant_points.h"
#include "renderer/base/text/utf8.h"

namespace foveola::analysis {
namespace {

/// One answer's share of a method's bar, in per cent: x from `low` to `high`.
struct BarSegment {
  double low = 0.0;
  double high = 0.0;
  std::size_t count = 0;
};

std::vector<BarSegment> bar_segments(const MethodRatings& ratings) {
  std::vector<BarSegment> segments;
  double end = 0.0;
  for (const RatingCount& answer : ratings.counts) {
    const double share =
        100.0 * static_cast<double>(answer.count) / static_cast<double>(ratings.description.n);
    segments.push_back({end, end + share, answer.count});
    end += share;
  }
  return segments;
}

/// Returns the shade of the answer of this index among `answers`: from light to dark along the
/// scale.
std::size_t shade_of(std::size_t answer, std::size_t answers) {
  return answer * palette::ratings.size() / answers;
}

std::string count_labels(const std::vector<BarSegment>& segments, std::size_t row) {
  constexpr double margin_percent = 1.0;
  constexpr double digit_percent = 2.0;
  std::string labels;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const BarSegment& segment = segments[i];
    const std::string count = std::to_string(segment.count);
    if (segment.count > 0 &&
        segment.high - segment.low >=
            margin_percent + digit_percent * static_cast<double>(count.size())) {
      const FigureColor& color =
          shade_of(i, segments.size()) < 3 ? palette::on_low_rating : palette::on_high_rating;
      labels += fmt::format("set label '{}' at {},{} center front textcolor rgb '{}'\n", count,
                            (segment.low + segment.high) / 2.0, row, color.rgb);
    }
  }
  return labels;
}

/// Writes the number of values at the right of a row, below `above` if that is not empty.
std::string row_summary(const std::string& above, std::size_t n, double row) {
  const auto line = [&](const std::string& text, double lines_down) {
    return fmt::format(
        "set label {} at graph 1.02, first {} offset 0,{} left front textcolor rgb '{}'\n",
        gnuplot_quoted(text), row, -lines_down, palette::ink.rgb);
  };
  const std::string count = fmt::format("n = {}", n);
  return above.empty() ? line(count, 0.0) : line(above, -0.5) + line(count, 0.5);
}

std::string rating_data(const std::vector<MethodRatings>& rows, std::size_t answer) {
  std::string data = fmt::format("$answer{} << END\n", answer);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].description.n > 0) {
      const BarSegment segment = bar_segments(rows[row])[answer];
      const auto y = static_cast<double>(row);
      data += fmt::format("{} {} {} {} {} {}\n", segment.low, y, segment.low, segment.high, y - 0.3,
                          y + 0.3);
    }
  }
  return data + "END\n";
}

std::string rating_plot(const std::vector<double>& points) {
  std::vector<std::string> layers;
  for (std::size_t answer = 0; answer < points.size(); ++answer) {
    layers.push_back(
        fmt::format("$answer{} using 1:2:3:4:5:6 with boxxyerror fillstyle solid 1 border "
                    "rgb '{}' linecolor rgb '{}' title '{:g}'",
                    answer, palette::ink.rgb, palette::ratings[shade_of(answer, points.size())].rgb,
                    points[answer]));
  }
  return fmt::format("plot {}\n", fmt::join(layers, ", \\\n"));
}

/// The labels of a scale's ends, each on a line of its own if both are too long for one.
struct EndLabels {
  std::string low;
  std::string high;

  bool exist() const { return !low.empty() || !high.empty(); }
  bool are_long() const {
    constexpr std::size_t max_characters = 64;
    return count_characters(low) + count_characters(high) > max_characters;
  }
};

/// Places the labels at left and right, this many lines above the plot's edge: `edge` 0 is the
/// lower one, 1 the upper.
std::string end_label_script(const EndLabels& ends, int edge, double low_lines, double high_lines) {
  const auto label = [&](const std::string& text, int x, std::string_view side, double lines) {
    return fmt::format("set label {} at graph {}, graph {} offset 0,{} {} textcolor rgb '{}'\n",
                       gnuplot_quoted(text), x, edge, lines, side, palette::ink.rgb);
  };
  return label(ends.low, 0, "left", low_lines) + label(ends.high, 1, "right", high_lines);
}

/// Layout above the bars, downwards: the notice of whose data they are, the key in as many lines as
/// it needs, and the end labels, aligned with the ends of the bars.
struct AboveBars {
  std::string script;
  int height = 0;  ///< In SVG units.
};

AboveBars above_bars(const Measure& measure, const std::vector<double>& points) {
  constexpr int line_height = 17;  // In SVG units.
  constexpr std::size_t max_in_line = 8;
  const auto end = [&](double point) {
    const std::string label = measure.label_of(point);
    return label.empty() ? label : fmt::format("{:g} {}", point, label);
  };
  const EndLabels ends{end(points.front()), end(points.back())};
  const int end_lines = !ends.exist() ? 0 : ends.are_long() ? 2 : 1;
  const int key_lines = static_cast<int>((points.size() - 1) / max_in_line) + 1;
  return {(ends.exist() ? end_label_script(ends, 1, end_lines - 0.5, 0.5) : "") +
              fmt::format("set key horizontal maxcols {} Left reverse samplen 1 width 0\n",
                          max_in_line),
          line_height * (2 + key_lines + end_lines)};
}

/// Writes the end labels below the axis of a figure of means, which spans the whole scale.
std::string labels_below_axis(const Measure& measure, const Interval& axis) {
  const EndLabels ends{measure.label_of(axis.low), measure.label_of(axis.high)};
  if (!ends.exist()) {
    return "";
  }
  return end_label_script(ends, 0, -2.6, ends.are_long() ? -3.6 : -2.6) +
         fmt::format("set bmargin {}\nset xlabel offset 0,{}\n", ends.are_long() ? 7 : 6,
                     ends.are_long() ? -2 : -1);
}

std::optional<Figure> bar_figure(const StudyTables& tables, std::size_t rating) {
  const Measure& measure = tables.set.measures[rating];
  const std::vector<double> points = measure.points();
  const std::vector<MethodRatings> rows = tables.ratings_of(rating);
  std::vector<std::string> methods;
  std::string data;
  std::string labels;
  std::size_t answers = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const MethodRatings& ratings = rows[row];
    methods.push_back(ratings.method);
    answers += ratings.description.n;
    if (ratings.description.n > 0) {
      labels += count_labels(bar_segments(ratings), row);
      labels += row_summary(mean_and_deviation(ratings.description, 2), ratings.description.n,
                            static_cast<double>(row));
    }
  }
  if (answers == 0) {
    return std::nullopt;
  }
  for (std::size_t answer = 0; answer < points.size(); ++answer) {
    data += rating_data(rows, answer);
  }
  const AboveBars above = above_bars(measure, points);
  const int height = above.height + lower_axis_height + 44 * static_cast<int>(methods.size());
  constexpr double below_notice = 22.0;  // In SVG units.
  return drawn_figure(
      rating_figure_name(measure), figure_width, height,
      figure_preamble(tables) + row_names(methods) + above.script +
          fmt::format("set key right top at graph 1, screen {}\nset tmargin at screen {}\n"
                      "set rmargin 14\nset xrange [0:100]\nset xlabel {}\n",
                      1.0 - below_notice / height, 1.0 - static_cast<double>(above.height) / height,
                      gnuplot_quoted("Ratings, " + measure.id() + ", per cent")) +
          labels + data + rating_plot(points));
}

/// One method's row in a figure of means.
struct MeanRow {
  std::vector<double> participants;
  Estimate estimate;
};

/// Returns a row per method; empty if no participant has every method's value in any scene.
std::vector<MeanRow> mean_rows(const StudyTables& tables, std::size_t rating) {
  const ParticipantValues values = participant_means(tables.set, rating);
  std::vector<MeanRow> rows;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    std::vector<double> participants;
    for (const std::vector<std::optional<double>>& row : values) {
      if (row[method]) {
        participants.push_back(*row[method]);
      }
    }
    if (const std::optional<Estimate> estimate = mean_estimate(participants)) {
      rows.push_back({std::move(participants), *estimate});
    }
  }
  return rows;
}

/// Returns the axis of a figure of means: the whole scale, or, for typed numbers, whose range may
/// be unused, the reach of participants' means and intervals.
Interval axis_of(const Measure& measure, const std::vector<MeanRow>& rows) {
  const study::Question& question = measure.question;
  if (question.kind == study::QuestionKind::likert) {
    return {question.minimum, question.maximum};
  }
  std::vector<double> drawn;
  for (const MeanRow& row : rows) {
    drawn.insert(drawn.end(), row.participants.begin(), row.participants.end());
    if (const auto& interval = row.estimate.interval) {
      drawn.insert(drawn.end(), {interval->low, interval->high});
    }
  }
  const auto [low, high] = std::ranges::minmax_element(drawn);
  const double margin = *high > *low ? 0.05 * (*high - *low) : 1.0;
  return {*low - margin, *high + margin};
}

constexpr double mean_row_height = 62.0;  // In SVG units.

JoinedPoints participant_points(const std::vector<MeanRow>& rows, const Interval& axis) {
  JoinedPoints points;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::vector<double> places;
    for (const double value : rows[row].participants) {
      places.push_back((value - axis.low) / (axis.high - axis.low));
    }
    points.push_back(points_in_row(row, rows[row].participants, places, static_cast<double>(row),
                                   mean_row_height));
  }
  return points;
}

/// Returns the estimates above their rows, and the numbers of participants beside them.
std::string mean_data(const std::vector<MeanRow>& rows) {
  constexpr double above = 0.34;
  std::string data;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto y = static_cast<double>(row);
    data += fmt::format("$estimates_{} << END\n{}END\n", row,
                        estimate_line(rows[row].estimate, y - above)) +
            row_summary("", rows[row].estimate.n, y);
  }
  return data;
}

std::string mean_plot(const StudyTables& tables) {
  std::vector<std::string> layers;
  if (draws_participants(tables)) {
    layers = participant_layers(tables, 0);
  }
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    layers.push_back(estimates_layer(fmt::format("$estimates_{}", method), method));
  }
  return fmt::format("plot {}\n", fmt::join(layers, ", \\\n"));
}

std::optional<Figure> mean_figure(const StudyTables& tables, std::size_t rating) {
  const Measure& measure = tables.set.measures[rating];
  const std::vector<MeanRow> rows = mean_rows(tables, rating);
  if (rows.empty()) {
    return std::nullopt;
  }
  const Interval axis = axis_of(measure, rows);
  const std::string unit = measure.unit();
  const int height = 148 + static_cast<int>(mean_row_height) * static_cast<int>(rows.size());
  return drawn_figure(
      rating_figure_name(measure), figure_width, height,
      figure_preamble(tables) + row_names(tables.set.methods) +
          fmt::format(
              "set key off\nset tmargin 2\nset rmargin 9\nset xrange [{}:{}]\n"
              "set xlabel {}\n"
              "set grid xtics linetype 1 linewidth 1 linecolor rgb '{}'\n",
              axis.low, axis.high,
              gnuplot_quoted("Ratings, " + measure.id() + (unit.empty() ? "" : ", " + unit)),
              palette::grid.rgb) +
          labels_below_axis(measure, axis) +
          (draws_participants(tables) ? participant_data({participant_points(rows, axis)}) : "") +
          mean_data(rows) + mean_plot(tables));
}

}  // namespace

std::optional<Figure> rating_figure(const StudyTables& tables, std::size_t rating) {
  return tables.set.measures[rating].points().empty() ? mean_figure(tables, rating)
                                                      : bar_figure(tables, rating);
}

}  // namespace foveola::analysis
