// Draws all figures by gnuplot, with shared colours.
#pragma once

#include <array>
#include <string>
#include <string_view>

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

struct Figure {
  std::string name;   ///< A file name without its extension.
  std::string svg;    ///< Content of an SVG file, on a white background.
  std::string png{};  ///< Content of a PNG file of twice the size, for slides; may be empty.
  std::string pdf{};  ///< Content of a PDF file without a date, so that equal figures give equal
  ///< bytes; may be empty.
  std::string script{};  ///< gnuplot's script of all of them, without its terminal.
};

/// Draws `script`, which sets no terminal. Throws Error if gnuplot is missing.
Figure drawn_figure(const std::string& name, int width, int height, const std::string& script);

/// Runs `gnuplot` with `script` on its standard input and without the user's start-up files.
/// Returns its output. Throws Error if it is not installed or fails.
std::string run_gnuplot(const std::string& script);

/// Returns whether gnuplot has a font for the letters of PNG and PDF, which it silently leaves out
/// otherwise. SVG contains texts.
bool has_font();

/// Returns `text` as gnuplot's single-quoted string, without expansion; control characters become
/// spaces.
std::string gnuplot_quoted(std::string_view text);

/// Returns `text` as the label of a tick, likewise. Gnuplot reads only these texts as formats of
/// the tick's number, with conversions after per cent signs.
std::string gnuplot_tick_label(std::string_view text);

/// Removes the date. The PDF's identifier then depends only on its content. Throws Error if this is
/// not a PDF.
std::string dateless_pdf(const std::string& pdf);

}  // namespace foveola::analysis
