// The words of a protocol's screens that stay English although the protocol is of another language.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"

namespace foveola::study {

struct UntranslatedTexts {
  /// The keys of the protocol under which its own words would stand: "texts.welcome", "mark",
  /// "rating"; "questionnaire[0].file" for a questionnaire that comes with Foveola.
  std::vector<std::string> keys;
  std::size_t of = 0;  ///< How many such keys there are, translated or not.
};

/// No keys if the protocol's language is English, of whatever country. Built-in texts without a
/// word in them need no translation, and do not count.
UntranslatedTexts untranslated_texts(const Protocol& protocol);

}  // namespace foveola::study
