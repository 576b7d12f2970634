#include "renderer/commands/warnings.h"

#include "renderer/base/print.h"
#include "renderer/base/utf8.h"

namespace foveola {

std::string warning_line(const std::string& warning) {
  return "foveola: warning: " + printable(warning);
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    print_text(stderr, "{}\n", warning_line(warning));
  }
}

}  // namespace foveola
