#include "renderer/commands/bench_facts.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "renderer/base/build_info.h"
#include "renderer/base/clock.h"

namespace foveola {
namespace {

/// The largest number k such that the k-th smallest and the k-th largest of `count` values enclose
/// the true median with at least 95 % confidence; 0 if no two do.
std::size_t place_of_ends(std::size_t count) {
  constexpr double allowed_beyond_an_end = 0.025;
  double probability = std::pow(0.5, static_cast<double>(count));  // that k values are below the
                                                                   // median
  double beyond = 0.0;                                             // that at most k values do
  for (std::size_t k = 0; k < count; ++k) {
    beyond += probability;
    if (beyond > allowed_beyond_an_end) {
      return k;
    }
    probability *= static_cast<double>(count - k) / static_cast<double>(k + 1);
  }
  return count;
}

/// In 10^9 bytes, to a tenth.
double memory_gb() {
  const auto pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  const auto page_bytes = static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::round(1e-8 * pages * page_bytes) / 10.0;
}

/// "Debian GNU/Linux 12 (bookworm)"; empty if unknown.
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

/// "Linux 6.1" of "Linux 6.1.0-18-amd64", without the system's own suffix.
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

Median median_of(std::vector<double> values) {
  std::ranges::sort(values);
  Median median{.value = values[values.size() / 2], .interval = {}};
  if (const std::size_t place = place_of_ends(values.size()); place > 0) {
    median.interval = {values[place - 1], values[values.size() - place]};
  }
  return median;
}

Median operator*(const Median& median, double factor) {
  Median product{.value = factor * median.value, .interval = {}};
  if (median.interval) {
    product.interval = {factor * median.interval->first, factor * median.interval->second};
  }
  return product;
}

Median operator/(double amount, const Median& median) {
  Median quotient{.value = amount / median.value, .interval = {}};
  if (median.interval) {
    quotient.interval = {amount / median.interval->second, amount / median.interval->first};
  }
  return quotient;
}

nlohmann::ordered_json json_of(const Median& median) {
  nlohmann::ordered_json json = {{"median", median.value}, {"low", nullptr}, {"high", nullptr}};
  if (median.interval) {
    json["low"] = median.interval->first;
    json["high"] = median.interval->second;
  }
  return json;
}

}  // namespace foveola
