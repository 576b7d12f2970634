// One input of the films' fuzzer: the bytes of an untrusted .film file, without the digest at its
// end, which no fuzzer would find.
#pragma once

#include <filesystem>
#include <string_view>

namespace foveola::test {

/// Writes `input` and its digest to a file in `folder`, reads that as a film, merges it with itself
/// and, if it is small, makes it a film again; throws std::logic_error if a pixel does not come out
/// of that as it must. Returns false if the file was refused with an Error.
bool read_film_input(const std::filesystem::path& folder, std::string_view input);

}  // namespace foveola::test
