// The state of the machine's disk and clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace foveola::study {

/// What an ordinary user may still write, in bytes, on the disk of the file at `path`, which need
/// not exist; its folder must.
std::uint64_t free_bytes_for(const std::filesystem::path& path);

/// Whether something synchronises the system's clock, as the kernel says; empty if it does not say.
std::optional<bool> is_clock_synchronised();

}  // namespace foveola::study
