#include "renderer/scene/textures/decoded_memory.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

namespace foveola {
namespace {

constexpr double mib = 1024.0 * 1024.0;

/// Half of the machine's memory, but at least 2 GiB.
std::size_t max_decoded_bytes() {
  const auto pages = static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES));
  return std::max(std::size_t{1} << 31,
                  pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) / 2);
}

/// Allowed to any file: twenty images of 2048 x 2048 pixels, each of a single colour.
constexpr std::size_t modest_bytes = std::size_t{1} << 28;

/// Deflate shrinks to no less than 1/1032 (zlib, "Technical Details"); decoding expands half floats
/// and common palettes two- to fourfold.
constexpr std::size_t max_growth = 4096;

}  // namespace

void require_modest_memory(std::size_t decoded_bytes, std::size_t encoded_bytes) {
  const auto in_mib = [](std::size_t bytes) { return static_cast<double>(bytes) / mib; };
  if (const std::size_t max_bytes = max_decoded_bytes(); decoded_bytes > max_bytes) {
    throw std::runtime_error(
        fmt::format("would take {:.0f} MiB of memory, of which {:.0f} are allowed here: its images "
                    "have to be smaller",
                    in_mib(decoded_bytes), in_mib(max_bytes)));
  }
  if (decoded_bytes > modest_bytes && decoded_bytes / max_growth > encoded_bytes) {
    throw std::runtime_error(
        fmt::format("would take {:.0f} MiB of memory, more than {:.0f} and more than {} times the "
                    "{} bytes of the files",
                    in_mib(decoded_bytes), in_mib(modest_bytes), max_growth, encoded_bytes));
  }
}

}  // namespace foveola
