#include "renderer/base/build_info.h"

#include <fstream>
#include <thread>

#include <sys/resource.h>
#include <sys/utsname.h>

namespace foveola {
namespace {

std::string processor_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);) {
    if (line.starts_with("model name")) {
      return line.substr(line.find(':') + 2);
    }
  }
  return "unknown processor";
}

}  // namespace

BuildInfo build_info() {
  return {
      .version = FOVEOLA_VERSION, .compiler = FOVEOLA_COMPILER, .build_type = FOVEOLA_BUILD_TYPE};
}

MachineInfo machine_info() {
  utsname names{};
  ::uname(&names);
  return {.processor = processor_name(),
          .cores = static_cast<int>(std::thread::hardware_concurrency()),
          .system = std::string(names.sysname) + " " + names.release};
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace foveola
