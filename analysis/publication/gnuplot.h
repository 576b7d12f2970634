// Drawing through the gnuplot program.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// Runs `gnuplot` with `script` on its standard input and without the user's start-up files;
/// returns what it prints. Throws Error if it is not installed or stops with an error.
std::string run_gnuplot(const std::string& script);

/// `text` as gnuplot's single-quoted string, in which nothing is expanded; control characters
/// become spaces.
std::string gnuplot_quoted(std::string_view text);

}  // namespace foveola::analysis
