// Suggests the intended word for a mistyped one, for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foveola {

/// Number of edits from `a` to `b`. An edit inserts, deletes or replaces a letter, or exchanges two
/// neighbours; no letter is edited twice. This is the "optimal string alignment" form of Damerau, A
/// technique for computer detection and correction of spelling errors, CACM 7(3), 1964. Letters are
/// bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The first of the words in `known` at the smallest edit distance from `word`. nullopt if that is
/// over two, over a third of the longer word's letters, or if a word has over 100 letters.
std::optional<std::string> similar_word(std::string_view word,
                                        const std::vector<std::string>& known);

/// "did you mean 'arcade'?" if `known` has a similar word, else `otherwise`: the remedy of an
/// error.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known,
                         const std::string& otherwise);

}  // namespace foveola
