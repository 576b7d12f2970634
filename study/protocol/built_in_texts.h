// The built-in English texts of the participant's screens.
#pragma once

#include <span>
#include <string_view>

namespace foveola::study {

struct BuiltInText {
  std::string_view id;
  std::string_view english;
};

std::span<const BuiltInText> built_in_texts();

/// Returns the texts that replace some of these in a headset: buttons by the names of the headset's
/// actions.
std::span<const BuiltInText> built_in_texts_in_headset();

/// Returns the ids of texts that Foveola 0.1.0 showed. Protocols in its records may have them.
std::span<const std::string_view> retired_text_ids();

}  // namespace foveola::study
