// Warnings on the terminal.
#pragma once

#include <string>
#include <vector>

namespace foveola {

/// One line each, on standard error.
void print_warnings(const std::vector<std::string>& warnings);

}  // namespace foveola
