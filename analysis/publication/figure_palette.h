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
inline constexpr FigureColor outline{"#0b6aa8", "--figure-outline"};
inline constexpr FigureColor material{"#b8500c", "--figure-material"};
inline constexpr std::array ratings = {
    FigureColor{"#e6edf4", "--figure-rating-1"}, FigureColor{"#b9cfe3", "--figure-rating-2"},
    FigureColor{"#7fa8cc", "--figure-rating-3"}, FigureColor{"#3c76aa", "--figure-rating-4"},
    FigureColor{"#12426f", "--figure-rating-5"}};
inline constexpr FigureColor on_low_rating{"#14222f", "--figure-on-low-rating"};
inline constexpr FigureColor on_high_rating{"#fdfeff", "--figure-on-high-rating"};
inline constexpr std::array all = {ink,        grid,          outline,       material,
                                   ratings[0], ratings[1],    ratings[2],    ratings[3],
                                   ratings[4], on_low_rating, on_high_rating};
}  // namespace palette

}  // namespace foveola::analysis
