#include "analysis/publication/rating_figures.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/dataset/participant_values.h"
#include "analysis/dataset/wording.h"
#include "analysis/publication/figure_drawing.h"
#include "analysis/publication/figure_palette.h"
#include "analysis/publication/gnuplot.h"

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

/// The colour of the answer of this index among `answers`: from light to dark along the scale.
std::size_t shade_of(std::size_t answer, std::size_t answers) {
  return answer * palette::ratings.size() / answers;
}

/// The counts inside the bars, where they fit.
std::string count_labels(const std::vector<BarSegment>& segments, std::size_t row) {
  constexpr double narrowest_percent = 4.0;
  std::string labels;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const BarSegment& segment = segments[i];
    if (segment.high - segment.low >= narrowest_percent) {
      const FigureColor& color =
          shade_of(i, segments.size()) < 3 ? palette::on_low_rating : palette::on_high_rating;
      labels += fmt::format("set label '{}' at {},{} center front textcolor rgb '{}'\n",
                            segment.count, (segment.low + segment.high) / 2.0, row, color.rgb);
    }
  }
  return labels;
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

/// The shares of the answers on a scale of few points.
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
      labels += fmt::format("set label {} at 102,{} left front textcolor rgb '{}'\n",
                            gnuplot_quoted(mean_and_deviation(ratings.description, 2)), row,
                            palette::ink.rgb);
    }
  }
  if (answers == 0) {
    return std::nullopt;
  }
  for (std::size_t answer = 0; answer < points.size(); ++answer) {
    data += rating_data(rows, answer);
  }
  const int height = 104 + 44 * static_cast<int>(methods.size());
  return drawn_figure(rating_figure_name(measure), 640, height,
                      figure_preamble(tables) + row_names(methods) +
                          "set key outside top right horizontal Left reverse samplen 1 width 2\n"
                          "set rmargin 14\nset xrange [0:100]\n" +
                          fmt::format("set xlabel {}\n",
                                      gnuplot_quoted("Ratings, " + measure.id() + ", per cent")) +
                          labels + data + rating_plot(points));
}

/// The axis of a figure of means. It is the whole scale, or, of numbers, which may have a range
/// that nobody uses, as far as participants' means and the intervals reach.
Interval axis_of(const Measure& measure, const std::vector<double>& drawn) {
  const study::Question& question = measure.question;
  if (question.kind == study::QuestionKind::likert) {
    return {question.minimum, question.maximum};
  }
  const auto [low, high] = std::minmax_element(drawn.begin(), drawn.end());
  const double margin = *high > *low ? 0.05 * (*high - *low) : 1.0;
  return {*low - margin, *high + margin};
}

/// The labels of the scale's ends, below the axis; the higher one a line further down where they
/// are too long for one line.
std::string end_labels(const Measure& measure, const Interval& axis) {
  constexpr std::size_t most_characters = 64;
  const std::string low = measure.label_of(axis.low);
  const std::string high = measure.label_of(axis.high);
  if (low.empty() && high.empty()) {
    return "";
  }
  const bool is_long = low.size() + high.size() > most_characters;
  const auto label = [](const std::string& text, double x, std::string_view side, double line) {
    return fmt::format("set label {} at first {}, graph 0 offset 0,{} {} textcolor rgb '{}'\n",
                       gnuplot_quoted(text), x, -line, side, palette::ink.rgb);
  };
  return label(low, axis.low, "left", 2.6) + label(high, axis.high, "right", is_long ? 3.6 : 2.6) +
         fmt::format("set bmargin {}\nset xlabel offset 0,{}\n", is_long ? 7 : 6,
                     is_long ? -2 : -1);
}

/// The data blocks $participants (x, y), a participant's line after the other, and $means (x, low,
/// high, y), above their rows.
std::string mean_data(const ParticipantValues& values, const std::vector<Estimate>& estimates) {
  std::string lines = "$participants << END\n";
  for (std::size_t i = 0; values.size() <= most_dots && i < values.size(); ++i) {
    for (std::size_t row = 0; row < values[i].size(); ++row) {
      lines += values[i][row] ? fmt::format("{} {}\n", *values[i][row], row) : "";
    }
    lines += "\n";
  }
  std::string means = "$means << END\n";
  for (std::size_t row = 0; row < estimates.size(); ++row) {
    constexpr double above = 0.24;
    const Estimate& estimate = estimates[row];
    const Interval interval = estimate.interval.value_or(Interval{estimate.value, estimate.value});
    means += fmt::format("{} {} {} {}\n", estimate.value, interval.low, interval.high,
                         static_cast<double>(row) - above);
  }
  return lines + "END\n" + means + "END\n";
}

std::string mean_plot(bool has_participants) {
  const std::string_view color = palette::marks[0].rgb;
  const std::string participants = fmt::format(
      "$participants using 1:2 with lines linewidth 1 linecolor rgb '{}' notitle, \\\n"
      "$participants using 1:2 with points pointtype 6 pointsize 0.55 linecolor rgb '{}' notitle, "
      "\\\n",
      palette::ratings[1].rgb, color);
  return fmt::format(
      "plot {}$means using 1:4:2:3 with xerrorbars pointtype 7 pointsize 0.9 linewidth 2 "
      "linecolor rgb '{}' notitle\n",
      has_participants ? participants : "", color);
}

/// Participants' means on a scale whose points are not counted.
std::optional<Figure> mean_figure(const StudyTables& tables, std::size_t rating) {
  const Measure& measure = tables.set.measures[rating];
  const ParticipantValues values = participant_means(tables.set, rating);
  std::vector<Estimate> estimates;
  std::vector<double> drawn;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    std::vector<double> of_method;
    for (const std::vector<std::optional<double>>& row : values) {
      if (row[method]) {
        of_method.push_back(*row[method]);
      }
    }
    const std::optional<Estimate> estimate = mean_estimate(of_method);
    if (!estimate) {
      return std::nullopt;  // No participant has every method's value in any scene.
    }
    estimates.push_back(*estimate);
    drawn.insert(drawn.end(), of_method.begin(), of_method.end());
    if (estimate->interval) {
      drawn.insert(drawn.end(), {estimate->interval->low, estimate->interval->high});
    }
  }
  const Interval axis = axis_of(measure, drawn);
  const std::string unit = measure.unit();
  const int height = 124 + 62 * static_cast<int>(estimates.size());
  return drawn_figure(rating_figure_name(measure), 640, height,
                      figure_preamble(tables) + row_names(tables.set.methods) +
                          fmt::format("set xrange [{}:{}]\nset xlabel {}\n"
                                      "set grid xtics linetype 1 linewidth 1 linecolor rgb '{}'\n",
                                      axis.low, axis.high,
                                      gnuplot_quoted("Ratings, " + measure.id() +
                                                     (unit.empty() ? "" : ", " + unit)),
                                      palette::grid.rgb) +
                          end_labels(measure, axis) + mean_data(values, estimates) +
                          mean_plot(values.size() <= most_dots));
}

}  // namespace

std::optional<Figure> rating_figure(const StudyTables& tables, std::size_t rating) {
  return tables.set.measures[rating].points().empty() ? mean_figure(tables, rating)
                                                      : bar_figure(tables, rating);
}

}  // namespace foveola::analysis
