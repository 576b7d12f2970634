// Warnings on the terminal.
#pragma once

#include <string>
#include <vector>

namespace foveola {

/// The line that a warning is printed as.
std::string warning_line(const std::string& warning);

/// Prints each on a line of its own, on standard error.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace foveola
