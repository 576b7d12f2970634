// The state of the machine's disk and clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace foveola::study {

/// What an ordinary user may still write, in bytes, on the disk of the file at `path`, which need
/// not exist; its folder must.
std::uint64_t free_bytes_for(const std::filesystem::path& path);

/// Whether something synchronises the system's clock, as the kernel says; empty if it does not say.
std::optional<bool> is_clock_synchronised();

/// By which rule the first core's frequency is set, as the kernel says; empty if it does not say.
std::string cpu_governor();

}  // namespace foveola::study
