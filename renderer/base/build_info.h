// The program's build and the machine, written into every record and measurement.
#pragma once

#include <cstdint>
#include <string>

namespace foveola {

struct BuildInfo {
  std::string version;   ///< "0.1.0"
  std::string compiler;  ///< "GNU 12.2.0"
  std::string build_type;
  std::string ray_tracer;       ///< "Embree 3.13.5"
  std::string instruction_set;  ///< of the loaded numeric libraries: "x86-64-v3"
  /// Instruction set of the ray tracer: "avx2", or "sse4.2" on processors without it. Rounding of
  /// hits depends on the processor only through this.
  std::string ray_instructions;
};
BuildInfo build_info();

/// The build on which pictures and times depend, whatever the machine: "Foveola 0.1.0 (GNU 12.2.0,
/// Release, Embree 3.13.5)". Unknown, empty parts are left out.
std::string program_name(const BuildInfo& build);

/// program_name with the instruction sets, on which the rounding of pictures depends: "Foveola
/// 0.1.0 (GNU 12.2.0, Release, Embree 3.13.5) with x86-64-v3 and rays by avx2".
std::string exact_name(const BuildInfo& build);

/// exact_name without the version, for file names that identify the source in another way:
/// "GNU 12.2.0, Release, Embree 3.13.5 with x86-64-v3 and rays by avx2".
std::string arithmetic_name(const BuildInfo& build);

struct MachineInfo {
  std::string processor;  ///< as the kernel names it: "AMD EPYC (family 23, model 1)"
  int cores = 0;
  std::string system;  ///< kernel name and release
};
MachineInfo machine_info();

/// Maximum resident memory of this process so far, in bytes.
std::uint64_t peak_memory_bytes();

}  // namespace foveola
