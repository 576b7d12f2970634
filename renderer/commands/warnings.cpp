#include "renderer/commands/warnings.h"

#include <fmt/format.h>

namespace foveola {

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    fmt::print(stderr, "foveola: warning: {}\n", warning);
  }
}

}  // namespace foveola
