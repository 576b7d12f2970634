// Keeps small files from asking for much memory: images can be compressed a thousandfold and more.
#pragma once

#include <cstddef>

namespace foveola {

/// Throws std::runtime_error that says so if images would take `decoded_bytes` of memory (coarser
/// levels not counted) and these are more than half of the machine's memory and 2 GiB, or more than
/// both 256 MiB and 4096 times the `encoded_bytes` of the files that they come from.
void require_modest_memory(std::size_t decoded_bytes, std::size_t encoded_bytes);

}  // namespace foveola
