// What the loader and a runtime tell each other first. Newer headers of OpenXR declare it too,
// older ones leave it to the loader's documentation; so these have names of their own.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

enum class NegotiatedStructure : std::uint32_t { loader_info = 1, runtime_request = 3 };
inline constexpr std::uint32_t negotiated_structure_version = 1;
inline constexpr std::uint32_t runtime_interface_version = 1;

struct LoaderInfo {
  NegotiatedStructure type;
  std::uint32_t structure_version;
  std::size_t structure_size;
  std::uint32_t min_interface_version;
  std::uint32_t max_interface_version;
  XrVersion min_api_version;
  XrVersion max_api_version;
};

struct RuntimeRequest {
  NegotiatedStructure type;
  std::uint32_t structure_version;
  std::size_t structure_size;
  std::uint32_t runtime_interface_version;
  XrVersion runtime_api_version;
  PFN_xrGetInstanceProcAddr get_instance_proc_addr;
};

}  // namespace foveola::test::openxr
