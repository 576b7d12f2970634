// The built-in English words of the participant's screens.
#pragma once

#include <span>
#include <string_view>

namespace foveola::study {

struct BuiltInText {
  std::string_view id;
  std::string_view english;
};

std::span<const BuiltInText> built_in_texts();

}  // namespace foveola::study
