// The figures' colours: one name for gnuplot and for the report's light and dark style.
#pragma once

#include <array>
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

}  // namespace foveola::analysis
