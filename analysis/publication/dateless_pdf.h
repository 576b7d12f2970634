// A PDF without the time at which it was made, so that the same figure gives the same bytes.
#pragma once

#include <string>

namespace foveola::analysis {

/// Shows the same. The identifier that a PDF has follows from what it holds. Throws Error if this
/// is no PDF.
std::string dateless_pdf(const std::string& pdf);

}  // namespace foveola::analysis
