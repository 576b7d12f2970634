// Writing to those who may take nothing for a while: a terminal that is stopped or far away, a pipe
// whose reader is busy.
#pragma once

#include <chrono>
#include <cstddef>
#include <string_view>

namespace foveola::study {

/// A terminal that has room for any has room for so many bytes; a pipe for more.
inline constexpr std::size_t most_taken_at_once = 256;

/// Writes the beginning of `text` once `descriptor` takes any. Returns how many bytes were taken: 0
/// if none were within `longest`, all if none ever will be again.
std::size_t write_taken(int descriptor, std::string_view text, std::chrono::milliseconds longest);

}  // namespace foveola::study
