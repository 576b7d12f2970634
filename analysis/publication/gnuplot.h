// Drawing through the gnuplot program.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

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

}  // namespace foveola::analysis
