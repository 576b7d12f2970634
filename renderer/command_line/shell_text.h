// Pieces of text that the scripts for different shells have in common.
#pragma once

#include <string>

namespace foveola {

/// `text` with each `from` in it put as `to`.
std::string replaced_all(std::string text, const std::string& from, const std::string& to);

/// The beginning of a description up to where it goes into details, for a list in a terminal:
/// "Number of threads" of "Number of threads; 0: one for each core".
std::string first_clause(const std::string& description);

}  // namespace foveola
