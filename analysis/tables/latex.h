// Writes LaTeX from the names and texts of any protocol.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// Returns a text for LaTeX, without commands of its own: symbols, Greek letters and minus signs as
/// mathematics, a number as 3.3e-05 as a power of ten, control characters as by `printable`. Long
/// names can break after each _ and /. Other letters stay: see `latex_needs`.
std::string latex_text(std::string_view text);

/// Returns comment lines with the packages that the LaTeX of `table` needs, and the engine if it
/// has letters unknown to pdfLaTeX.
std::string latex_needs(std::string_view table);

}  // namespace foveola::analysis
