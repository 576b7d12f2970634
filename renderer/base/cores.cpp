#include "renderer/base/cores.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <thread>

#include <sched.h>

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// Relative to the mount of version 2's cgroups; empty if there is none.
fs::path own_cgroup() {
  const std::string of_version_2 = "0::/";
  std::ifstream cgroups("/proc/self/cgroup");
  for (std::string line; std::getline(cgroups, line);) {
    if (line.starts_with(of_version_2)) {
      return line.substr(of_version_2.size());
    }
  }
  return {};
}

int cores_of_affinity() {
  cpu_set_t cores;
  return ::sched_getaffinity(0, sizeof cores, &cores) == 0
             ? CPU_COUNT(&cores)
             : static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

std::optional<double> cgroup_cores(const fs::path& mount, const fs::path& cgroup) {
  std::optional<double> fewest;
  fs::path folder = mount;
  const auto look = [&] {
    // "max" in place of the first is no number.
    double quota_us = 0.0;
    double period_us = 0.0;
    if (std::ifstream(folder / "cpu.max") >> quota_us >> period_us && period_us > 0.0) {
      fewest = std::min(fewest.value_or(HUGE_VAL), quota_us / period_us);
    }
  };
  look();
  for (const fs::path& name : cgroup) {
    folder /= name;
    look();
  }
  return fewest;
}

int usable_cores() {
  const int cores = cores_of_affinity();
  const double quota = cgroup_cores("/sys/fs/cgroup", own_cgroup()).value_or(cores);
  return std::max(1, static_cast<int>(std::ceil(std::min<double>(cores, quota))));
}

}  // namespace foveola
