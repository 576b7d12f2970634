#include "renderer/scene/decoded_memory.h"

#include <stdexcept>

#include <fmt/format.h>

namespace foveola {
namespace {

constexpr double mib = 1024.0 * 1024.0;
constexpr std::size_t most_bytes = std::size_t{1} << 31;

/// What any file may ask for: twenty images of 2048 x 2048 pixels, each of a single colour.
constexpr std::size_t modest_bytes = std::size_t{1} << 28;

/// Deflate shrinks to no less than 1/1032 (zlib, "Technical Details"), and half floats and usual
/// palettes grow two- to fourfold when they are decoded.
constexpr std::size_t most_growth = 4096;

}  // namespace

void require_modest_memory(std::size_t decoded_bytes, std::size_t encoded_bytes) {
  const auto in_mib = [](std::size_t bytes) { return static_cast<double>(bytes) / mib; };
  if (decoded_bytes > most_bytes) {
    throw std::runtime_error(
        fmt::format("would take {:.0f} MiB of memory; up to {:.0f} are allowed",
                    in_mib(decoded_bytes), in_mib(most_bytes)));
  }
  if (decoded_bytes > modest_bytes && decoded_bytes / most_growth > encoded_bytes) {
    throw std::runtime_error(
        fmt::format("would take {:.0f} MiB of memory, more than {:.0f} and more than {} times the "
                    "{} bytes of the files",
                    in_mib(decoded_bytes), in_mib(modest_bytes), most_growth, encoded_bytes));
  }
}

}  // namespace foveola
