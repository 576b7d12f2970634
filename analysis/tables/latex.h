// LaTeX, whatever the names and words of a protocol are made of.
#pragma once

#include <string>
#include <string_view>

namespace foveola::analysis {

/// A text as LaTeX sets it, with no command in it that it brought along: symbols, Greek letters and
/// minus signs as mathematics, a number as 3.3e-05 as a power of ten, control characters as
/// `printable` has them; a long name can be broken behind each _ and /. Other letters stay as they
/// are: see `latex_needs`.
std::string latex_text(std::string_view text);

/// Comment lines that say which packages a table needs whose LaTeX is `table`, and which LaTeX if
/// it has letters that pdfLaTeX does not know.
std::string latex_needs(std::string_view table);

}  // namespace foveola::analysis
