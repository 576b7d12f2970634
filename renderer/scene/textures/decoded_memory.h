// Limits the memory that small files can request: images may be compressed a thousandfold.
#pragma once

#include <cstddef>

namespace foveola {

/// Throws std::runtime_error if images of `decoded_bytes` (without coarser levels) exceed either of
/// two limits: the larger of half the machine's memory and 2 GiB; or the larger of 256 MiB and 4096
/// times their files' `encoded_bytes`.
void require_modest_memory(std::size_t decoded_bytes, std::size_t encoded_bytes);

}  // namespace foveola
