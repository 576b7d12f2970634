// The processors that this process may use.
#pragma once

#include <filesystem>
#include <optional>

namespace foveola {

/// The number of cores in the process's affinity, or as many as its cgroup's quota of time is
/// worth, rounded up, if that is fewer. At least 1.
int usable_cores();

/// The cores' worth of time that `cgroup` and those above it have, by their cpu.max (Linux,
/// Documentation/admin-guide/cgroup-v2.rst); empty without a limit. mount: of all cgroups.
std::optional<double> cgroup_cores(const std::filesystem::path& mount,
                                   const std::filesystem::path& cgroup);

}  // namespace foveola
