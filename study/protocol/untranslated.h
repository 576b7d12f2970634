// Finds screen texts that stay English although the protocol is in another language.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

struct UntranslatedTexts {
  /// Keys of the protocol under which its own texts would be: "texts.welcome", "mark", "rating";
  /// "questionnaire[0].file" for a questionnaire that comes with Foveola.
  std::vector<std::string> keys;
  std::size_t of = 0;  ///< Number of such keys, translated or not.
};

/// Returns no keys if the protocol's language is English, of any country. Built-in texts without a
/// word need no translation, and do not count.
UntranslatedTexts untranslated_texts(const Protocol& protocol);

}  // namespace foveola::study
