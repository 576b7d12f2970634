// Text broken into lines that fit.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace foveola {

/// Lines longer than this are hard to find the way back from (Bringhurst, "The Elements of
/// Typographic Style", 2.1.2: 45 to 75 characters).
inline constexpr std::size_t most_line_characters = 70;

/// Pixels that a line of text takes.
using LineWidth = std::function<float(std::string_view line)>;

/// Breaks UTF-8 at its spaces, and at its line breaks, into lines of at most `width_px` and
/// most_line_characters; a word that is longer is broken within, and a letter that is wider stands
/// in a line by itself. At least one line.
std::vector<std::string> wrapped(std::string_view text, float width_px, const LineWidth& width_of);

/// The widest word, in pixels.
float widest_word_px(std::string_view text, const LineWidth& width_of);

}  // namespace foveola
