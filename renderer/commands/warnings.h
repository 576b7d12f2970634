// Warnings on the terminal.
#pragma once

#include <string>
#include <vector>

namespace foveola {

/// Prints each on a line of its own, on standard error.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace foveola
