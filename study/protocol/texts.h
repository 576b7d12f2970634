// The words of the participant's screens: the built-in ones, which a protocol may replace.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foveola::study {

/// The ids of texts that a protocol may set, without duplicates.
std::vector<std::string> known_text_ids();

/// The protocol's words by their ids. A name in braces, as in "{trial} of {trials}", is filled in
/// when they are shown.
using Texts = std::map<std::string, std::string>;

/// The words of `id`, which must be known: those of `texts`, else the built-in ones.
std::string text_of(const Texts& texts, std::string_view id);

/// The same words for a participant in a headset: what `texts` leaves to the built-in ones names
/// the headset's buttons instead of keys.
Texts texts_in_headset(Texts texts);

/// The names in braces in a text, in their order.
std::vector<std::string> names_in(std::string_view text);

/// The text with its names in braces replaced. Names that `values` lacks stay as they are.
std::string filled(std::string_view text,
                   const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace foveola::study
