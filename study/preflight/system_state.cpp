#include "study/preflight/system_state.h"

#include <sys/timex.h>

namespace fs = std::filesystem;

namespace foveola::study {

std::uint64_t free_bytes_for(const fs::path& path) {
  return fs::space(fs::absolute(path).parent_path()).available;
}

std::optional<bool> is_clock_synchronised() {
  timex state{};
  const int clock = ::adjtimex(&state);
  if (clock < 0) {
    return std::nullopt;
  }
  return clock != TIME_ERROR;
}

}  // namespace foveola::study
