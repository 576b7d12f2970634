// What was meant by a mistyped word, for messages that say so.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foveola {

/// How many edits make `a` into `b`: a letter put in, left out or replaced, or two neighbours
/// exchanged, no letter being edited twice (the "optimal string alignment" form of Damerau, A
/// technique for computer detection and correction of spelling errors, CACM 7(3), 1964). Letters
/// are bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The first of the words in `known` that fewest edits make into `word`, if these are at most two
/// and at most a third of the longer word's letters. Words of over 100 letters have none.
std::optional<std::string> similar_word(std::string_view word,
                                        const std::vector<std::string>& known);

/// "did you mean 'arcade'?" where there is a similar word in `known`, else `otherwise`: what an
/// error tells a user to do.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known,
                         const std::string& otherwise);

}  // namespace foveola
