// Texts of the participant's screens: the built-in ones, which a protocol may replace.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foveola::study {

/// Returns the ids of texts that a protocol may set, without duplicates.
std::vector<std::string> known_text_ids();

/// The protocol's texts by id. A name in braces, as in "{trial} of {trials}", is replaced when they
/// are shown.
using Texts = std::map<std::string, std::string>;

/// Returns the text of `id`, which must be known: that of `texts`, else the built-in one.
std::string text_of(const Texts& texts, std::string_view id);

/// Returns the texts for a participant in a headset: built-in texts that `texts` does not replace
/// name the headset's buttons instead of keys.
Texts texts_in_headset(Texts texts);

/// Returns the names in braces in a text, in their order.
std::vector<std::string> names_in(std::string_view text);

/// Returns the text with its names in braces replaced. Names that `values` lacks stay.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace foveola::study
