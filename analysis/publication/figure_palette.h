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
inline constexpr FigureColor grid{"#e1e4e8", "--figure-grid"};
inline constexpr std::array marks = {
    FigureColor{"#0b6aa8", "--figure-mark-1"}, FigureColor{"#b8500c", "--figure-mark-2"},
    FigureColor{"#2f7d32", "--figure-mark-3"}, FigureColor{"#7b3fa0", "--figure-mark-4"},
    FigureColor{"#8a6d00", "--figure-mark-5"}, FigureColor{"#a8245e", "--figure-mark-6"}};
inline constexpr std::array ratings = {
    FigureColor{"#e6edf4", "--figure-rating-1"}, FigureColor{"#b9cfe3", "--figure-rating-2"},
    FigureColor{"#7fa8cc", "--figure-rating-3"}, FigureColor{"#3c76aa", "--figure-rating-4"},
    FigureColor{"#12426f", "--figure-rating-5"}};
inline constexpr FigureColor on_low_rating{"#14222f", "--figure-on-low-rating"};
inline constexpr FigureColor on_high_rating{"#fdfeff", "--figure-on-high-rating"};
inline constexpr std::array all = {ink,        grid,          marks[0],      marks[1],
                                   marks[2],   marks[3],      marks[4],      marks[5],
                                   ratings[0], ratings[1],    ratings[2],    ratings[3],
                                   ratings[4], on_low_rating, on_high_rating};
}  // namespace palette

}  // namespace foveola::analysis
