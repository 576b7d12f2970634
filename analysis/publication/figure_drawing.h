// What all figures are drawn with: gnuplot, colours, frame, typeface, rows, points and estimates.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset/study_tables.h"
#include "analysis/publication/figures.h"
#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

struct FigureColor {
  std::string_view rgb;       ///< On a white background, as "#rrggbb".
  std::string_view property;  ///< The custom property of the report's style sheet.
};

namespace palette {
inline constexpr FigureColor ink{"#1f2328", "--figure-ink"};
inline constexpr FigureColor paper{"#ffffff", "--figure-paper"};
inline constexpr FigureColor grid{"#e1e4e8", "--figure-grid"};
/// The thin lines that join the points of one participant.
inline constexpr FigureColor participant{"#b4bec8", "--figure-participant"};
inline constexpr std::array methods = {
    FigureColor{"#0b6aa8", "--figure-method-1"}, FigureColor{"#b8500c", "--figure-method-2"},
    FigureColor{"#2f7d32", "--figure-method-3"}, FigureColor{"#7b3fa0", "--figure-method-4"},
    FigureColor{"#8a6d00", "--figure-method-5"}, FigureColor{"#a8245e", "--figure-method-6"}};
inline constexpr std::array ratings = {
    FigureColor{"#e6edf4", "--figure-rating-1"}, FigureColor{"#b9cfe3", "--figure-rating-2"},
    FigureColor{"#7fa8cc", "--figure-rating-3"}, FigureColor{"#3c76aa", "--figure-rating-4"},
    FigureColor{"#12426f", "--figure-rating-5"}};
inline constexpr FigureColor on_low_rating{"#14222f", "--figure-on-low-rating"};
inline constexpr FigureColor on_high_rating{"#fdfeff", "--figure-on-high-rating"};
inline constexpr std::array all = {
    ink,        paper,      grid,       participant,   methods[0],    methods[1],
    methods[2], methods[3], methods[4], methods[5],    ratings[0],    ratings[1],
    ratings[2], ratings[3], ratings[4], on_low_rating, on_high_rating};
}  // namespace palette

// In SVG units.
inline constexpr int figure_width = 640;
inline constexpr int lower_axis_height = 70;
inline constexpr int upper_axis_height = 46;

/// The frame and the typeface that all figures share, and whose data they show.
std::string figure_preamble(const StudyTables& tables);

/// Names the rows of a figure by its methods; row 0 is at the top.
std::string row_names(const std::vector<std::string>& methods);

/// The ids of these marks, which are indices of the set's measures.
std::vector<std::string> ids_of(const StudyTables& tables, const std::vector<std::size_t>& marks);

/// A method has the same colour in every figure, and the same shape of points, so that methods
/// differ by more than their colours. `method` is its index in the set.
const FigureColor& method_color(std::size_t method);
int hollow_point(std::size_t method);

/// A line of a data block: x, the ends of its interval, y.
std::string estimate_line(const Estimate& estimate, double y);

/// Plots such a block: filled points on their intervals.
std::string estimates_layer(const std::string& block, std::size_t method);

/// The same with hollow points.
std::string hollow_estimates_layer(const std::string& block, std::size_t method);

/// An entry of the key for the method's estimates.
std::string method_key(const StudyTables& tables, std::size_t method);

/// Draws `script`, which sets no terminal. Throws Error if gnuplot is missing.
Figure drawn_figure(const std::string& name, int width, int height, const std::string& script);

/// Runs `gnuplot` with `script` on its standard input and without the user's start-up files;
/// returns what it prints. Throws Error if it is not installed or stops with an error.
std::string run_gnuplot(const std::string& script);

/// Whether gnuplot has a font to draw letters into a PNG or a PDF with; it leaves them out without
/// a word if there is none. An SVG has texts as they are.
bool has_font();

/// `text` as gnuplot's single-quoted string, in which nothing is expanded; control characters
/// become spaces.
std::string gnuplot_quoted(std::string_view text);

/// `text` as the label of a tick, likewise. Gnuplot reads these, unlike other texts, as formats of
/// the tick's number, in which it would take a per cent sign for a conversion.
std::string gnuplot_tick_label(std::string_view text);

/// Shows the same. The identifier that a PDF has follows from what it holds. Throws Error if this
/// is no PDF.
std::string dateless_pdf(const std::string& pdf);

/// Groups one under the other, each with the same rows below its heading; y counts downwards from
/// 0, in rows.
struct GroupedRows {
  std::vector<std::string> headings;
  std::vector<std::string> rows;
  double heading_height = 0.5;  ///< In rows.

  double group_height() const { return heading_height + static_cast<double>(rows.size()); }
  double height() const { return group_height() * static_cast<double>(headings.size()); }
  /// The middle of a row.
  double y(std::size_t group, std::size_t row) const {
    return group_height() * static_cast<double>(group) + heading_height + static_cast<double>(row) +
           0.5;
  }
};

/// A line across the plot.
std::string horizontal_rule(double y, const FigureColor& color);

/// gnuplot's y axis: the rows' names beside it, the headings in the plot, lines between groups.
std::string row_axis(const GroupedRows& rows);

}  // namespace foveola::analysis
