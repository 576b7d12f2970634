// Reads the state of the machine's disk and clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace foveola::study {

/// Returns the bytes that an ordinary user may still write on the disk of the file at `path`, which
/// need not exist; its folder must.
std::uint64_t free_bytes_for(const std::filesystem::path& path);

/// Returns whether the kernel reports a synchronised clock; empty if it does not report.
std::optional<bool> is_clock_synchronised();

/// Returns the kernel's frequency governor of the first core; empty if it does not report.
std::string cpu_governor();

}  // namespace foveola::study
