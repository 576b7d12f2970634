// One input of the HID fuzzer: what a device that was built to do harm might say.
#pragma once

#include <cstdint>
#include <span>

namespace foveola::test {

/// Reads an input as the connection to a device: two bytes, the lower first, with the size of a
/// report descriptor, the descriptor, and for each read a byte with its size and its bytes, all cut
/// off where the input ends. Each read is taken as every feature report, too.
///
/// Returns whether it was an eye tracker that sent a sample. Throws std::logic_error if what comes
/// out cannot be: a number outside its report, a value that is not finite, a direction of another
/// length than 1, a time after the arrival.
bool read_hid_input(std::span<const std::uint8_t> input);

}  // namespace foveola::test
