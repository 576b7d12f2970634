// `foveola bench sampling --density`: where a method's samples really fall.
#pragma once

#include <string>

namespace foveola {

/// Prints how many samples a square degree of each ring around the gaze gets, counted on a film,
/// beside what the method states, as a table or as JSON. Throws Error for a text that makes no
/// sense.
void print_density(const std::string& method, bool as_json);

}  // namespace foveola
