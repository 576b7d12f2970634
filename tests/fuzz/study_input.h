// One input of the studies' fuzzer: what somebody did to a study's file.
#pragma once

#include <filesystem>

#include "tests/fuzz/input_bytes.h"

namespace foveola::test {

/// Makes the input's changes in a copy of a small study, as a file in `folder`, and reads that as
/// study verify, status, summary and analyze do.
///
/// The first byte has two bits. The lowest: hashes are made anew after the changes, so that they
/// hold. The next: the changes are of the file's bytes, each an offset of three bytes, a size and
/// that many bytes. Else each is of a value, whatever a column is declared to hold: a column, a row
/// and a kind in a byte each, then
///   0, 1     an integer or a real number in eight bytes
///   2, 3     a text or a blob: its size in a byte, and its bytes
///   4        NULL
///   others   new bytes in what is there, uncompressed if it is a chunk, and compressed again:
///   their
///            place in two bytes, how many they replace, their size and the bytes
///
/// Returns whether nothing was refused and no fault was found. Whatever is thrown is a fault of the
/// program.
bool read_study_input(const std::filesystem::path& folder, Bytes input);

}  // namespace foveola::test
