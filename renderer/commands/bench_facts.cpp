#include "renderer/commands/bench_facts.h"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"

namespace foveola {
namespace {

/// In 10^9 bytes, to a tenth.
double memory_gb() {
  const auto pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  const auto page_bytes = static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::round(1e-8 * pages * page_bytes) / 10.0;
}

/// "Debian GNU/Linux 12 (bookworm)"; empty if the system does not say.
std::string distribution() {
  std::ifstream release("/etc/os-release");
  constexpr std::string_view key = "PRETTY_NAME=";
  for (std::string line; std::getline(release, line);) {
    if (line.starts_with(key)) {
      std::string name = line.substr(key.size());
      std::erase(name, '"');
      return name;
    }
  }
  return {};
}

/// "Linux 6.1" of "Linux 6.1.0-18-amd64": what follows is each system's own.
std::string kernel_series(const std::string& system) {
  const std::size_t major_end = system.find('.');
  return major_end == std::string::npos ? system
                                        : system.substr(0, system.find('.', major_end + 1));
}

}  // namespace

nlohmann::ordered_json program_facts() {
  const BuildInfo build = build_info();
  return {{"version", build.version},
          {"compiler", build.compiler},
          {"build_type", build.build_type},
          {"instruction_set", build.instruction_set},
          {"ray_tracer", build.ray_tracer}};
}

nlohmann::ordered_json bench_facts() {
  const MachineInfo machine = machine_info();
  nlohmann::ordered_json facts = program_facts();
  facts.update({{"processor", machine.processor},
                {"cores", machine.cores},
                {"memory_gb", memory_gb()},
                {"system", kernel_series(machine.system)},
                {"distribution", distribution()},
                {"date", utc_now().substr(0, std::string_view("2026-01-31").size())}});
  return facts;
}

nlohmann::ordered_json measured_once(double value) {
  return {{"value", value}, {"low", nullptr}, {"high", nullptr}};
}

}  // namespace foveola
