#include "renderer/base/build_info.h"

#include <fstream>
#include <map>
#include <thread>

#include <sys/resource.h>
#include <sys/utsname.h>

namespace foveola {
namespace {

/// The kernel's facts of the first processor.
std::map<std::string, std::string> first_processor() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  std::map<std::string, std::string> fields;
  for (std::string line; std::getline(cpuinfo, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && colon + 2 < line.size()) {
      fields[line.substr(0, line.find_first_of("\t:"))] = line.substr(colon + 2);
    }
  }
  return fields;
}

/// In a virtual machine, processors with different arithmetic may share a name.
std::string processor_name() {
  std::map<std::string, std::string> fields = first_processor();
  std::string name =
      fields.contains("model name") ? fields["model name"] : std::string("unknown processor");
  if (fields.contains("cpu family") && fields.contains("model")) {
    name += " (family " + fields["cpu family"] + ", model " + fields["model"] + ")";
  }
  return name;
}

/// The highest level of the x86-64 psABI (1.0, 3.1.1) that this source is compiled for.
constexpr const char* instruction_set() {
#if defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
  return "x86-64-v4";
#elif defined(__AVX2__) && defined(__BMI2__) && defined(__FMA__)
  return "x86-64-v3";
#elif defined(__SSE4_2__) && defined(__POPCNT__)
  return "x86-64-v2";
#elif defined(__x86_64__)
  return "x86-64";
#else
  return "not x86-64";
#endif
}

/// Embree would use the widest instructions of the processor.
const char* ray_instructions() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 ? "avx2" : "sse4.2";
#else
  return "";
#endif
}

/// The known tools: "GNU 12.2.0, Release, Embree 3.13.5".
std::string tools_of(const BuildInfo& build) {
  std::string parts;
  for (const std::string& part : {build.compiler, build.build_type, build.ray_tracer}) {
    if (!part.empty()) {
      parts += (parts.empty() ? "" : ", ") + part;
    }
  }
  return parts;
}

/// The known instruction sets: " with x86-64-v3 and rays by avx2".
std::string instructions_of(const BuildInfo& build) {
  std::string text;
  if (!build.instruction_set.empty()) {
    text += " with " + build.instruction_set;
  }
  if (!build.ray_instructions.empty()) {
    text += " and rays by " + build.ray_instructions;
  }
  return text;
}

}  // namespace

BuildInfo build_info() {
  return {.version = FOVEOLA_VERSION,
          .compiler = FOVEOLA_COMPILER,
          .build_type = FOVEOLA_BUILD_TYPE,
          .ray_tracer = FOVEOLA_RAY_TRACER,
          .instruction_set = instruction_set(),
          .ray_instructions = ray_instructions()};
}

std::string program_name(const BuildInfo& build) {
  const std::string tools = tools_of(build);
  return "Foveola " + build.version + (tools.empty() ? "" : " (" + tools + ")");
}

std::string exact_name(const BuildInfo& build) {
  return program_name(build) + instructions_of(build);
}

std::string arithmetic_name(const BuildInfo& build) {
  return tools_of(build) + instructions_of(build);
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
