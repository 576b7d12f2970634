// Which program and which machine: written into every record and measurement.
#pragma once

#include <cstdint>
#include <string>

namespace foveola {

struct BuildInfo {
  std::string version;   ///< "0.1.0"
  std::string compiler;  ///< "GNU 12.2.0"
  std::string build_type;
  std::string ray_tracer;       ///< what traces the rays: "Embree 3.13.5"
  std::string instruction_set;  ///< what the loaded numeric libraries use: "x86-64-v3"
  /// What rays are traced with: "avx2", or "sse4.2" on processors without it. The last bits of what
  /// they meet depend on it, and on nothing else of a processor.
  std::string ray_instructions;
};
BuildInfo build_info();

/// What pictures and times depend on, whatever machine the program runs on: "Foveola 0.1.0 (GNU
/// 12.2.0, Release, Embree 3.13.5)". What is not known, and so empty, is left out.
std::string program_name(const BuildInfo& build);

/// The same with its instructions: what the last bits of pictures depend on. "Foveola 0.1.0 (GNU
/// 12.2.0, Release, Embree 3.13.5) with x86-64-v3 and rays by avx2".
std::string exact_name(const BuildInfo& build);

/// What of that name the last bits depend on while the source stays the same, for files whose name
/// says otherwise what they are made of: "GNU 12.2.0, Release, Embree 3.13.5 with x86-64-v3 and
/// rays by avx2".
std::string arithmetic_name(const BuildInfo& build);

struct MachineInfo {
  std::string processor;  ///< as the kernel names it: "AMD EPYC (family 23, model 1)"
  int cores = 0;
  std::string system;  ///< kernel name and release
};
MachineInfo machine_info();

/// The most memory this process has had resident, in bytes.
std::uint64_t peak_memory_bytes();

}  // namespace foveola
