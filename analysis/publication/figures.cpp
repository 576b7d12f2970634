#include "analysis/publication/figures.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// The frame and the typeface that all figures share.
std::string preamble(const StudyTables& tables) {
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

/// Blanks out when the PDF was made, so that the same study gives the same bytes; nothing moves,
/// since a PDF's table of contents counts bytes.
std::string without_date(std::string pdf) {
  const std::size_t begin = pdf.find("/CreationDate");
  const std::size_t end = begin == std::string::npos ? begin : pdf.find(')', begin);
  if (end != std::string::npos) {
    pdf.replace(begin, end + 1 - begin, end + 1 - begin, ' ');
  }
  return pdf;
}

Figure drawn(const std::string& name, int width, int height, const std::string& script) {
  const std::string terminal = fmt::format(
      "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,14' background 'white'\n",
      width, height);
  return {name, run_gnuplot(terminal + script), width, height, script};
}

/// Names the rows of a figure; row 0 is at the top.
std::string row_names(const std::vector<std::string>& methods) {
  std::string tics;
  for (std::size_t row = 0; row < methods.size(); ++row) {
    tics += fmt::format("{}{} {}", row > 0 ? ", " : "", gnuplot_quoted(method_label(methods[row])),
                        row);
  }
  return fmt::format("set ytics ({})\nset yrange [{}:-0.6]\n", tics,
                     static_cast<double>(methods.size()) - 0.4);
}

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
  return drawn(name, 640, height,
               preamble(tables) + row_names(names) +
                   "set key outside top right horizontal Left reverse samplen 1.5 width 1\n" +
                   axis +
                   fmt::format("set grid xtics linetype 1 linewidth 1 linecolor rgb '{}'\n",
                               palette::grid.rgb) +
                   data + time_plot(tables));
}

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

std::optional<Figure> rating_figure(const StudyTables& tables, std::size_t rating) {
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
  if (answers == 0 || points.empty()) {
    return std::nullopt;
  }
  for (std::size_t answer = 0; answer < points.size(); ++answer) {
    data += rating_data(rows, answer);
  }
  const int height = 104 + 44 * static_cast<int>(methods.size());
  return drawn(rating_figure_name(measure), 640, height,
               preamble(tables) + row_names(methods) +
                   "set key outside top right horizontal Left reverse samplen 1 width 2\n"
                   "set rmargin 14\nset xrange [0:100]\n" +
                   fmt::format("set xlabel {}\n",
                               gnuplot_quoted("Ratings, " + measure.id() + ", per cent")) +
                   labels + data + rating_plot(points));
}

}  // namespace

std::string rating_figure_name(const Measure& rating) { return "ratings_" + rating.id(); }

std::vector<Figure> draw_figures(const StudyTables& tables) {
  std::vector<std::optional<Figure>> drawn_ones = {relative_figure(tables), seconds_figure(tables)};
  for (const std::size_t rating : tables.set.ratings()) {
    drawn_ones.push_back(rating_figure(tables, rating));
  }
  std::vector<Figure> figures;
  for (const std::optional<Figure>& figure : drawn_ones) {
    if (figure) {
      figures.push_back(*figure);
    }
  }
  return figures;
}

std::string pdf_of(const Figure& figure) {
  constexpr double units_per_inch = 96.0;
  const std::string terminal = fmt::format(
      "set terminal pdfcairo size {:.4f}in,{:.4f}in noenhanced font 'sans-serif,10.5' "
      "fontscale 1 linewidth 1 pointscale 1.2 background rgb 'white'\n",
      figure.width / units_per_inch, figure.height / units_per_inch);
  return without_date(run_gnuplot(terminal + figure.script));
}

std::string png_of(const Figure& figure) {
  const std::string terminal = fmt::format(
      "set terminal pngcairo size {},{} noenhanced font 'sans-serif,10.5' fontscale 2 "
      "linewidth 2 pointscale 2 background rgb 'white'\n",
      2 * figure.width, 2 * figure.height);
  return run_gnuplot(terminal + figure.script);
}

}  // namespace foveola::analysis
