#include "study/preflight/system_state.h"

#include <fstream>

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

std::string cpu_governor() {
  std::ifstream file("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  std::string governor;
  std::getline(file, governor);
  return governor;
}

}  // namespace foveola::study
