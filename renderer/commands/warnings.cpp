#include "renderer/commands/warnings.h"

#include <fmt/format.h>

#include "renderer/base/utf8.h"

namespace foveola {

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    fmt::print(stderr, "foveola: warning: {}\n", printable(warning));
  }
}

}  // namespace foveola
