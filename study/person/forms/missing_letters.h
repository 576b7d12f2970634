// Letters of a protocol's words that no font at hand has, before a participant misses them.
#pragma once

#include <string>
#include <vector>

#include "renderer/window/screens/screen_fonts.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Words that participants read, and where the protocol has them: "texts.consent",
/// "questionnaire.background.age".
struct ShownText {
  std::string key;
  std::string words;
};

/// All that are the protocol's own, without the built-in ones.
std::vector<ShownText> shown_texts(const Protocol& protocol);

struct MissingLetters {
  std::string key;
  Characters characters;
};

/// For each text with letters that would be shown as question marks.
std::vector<MissingLetters> missing_letters(const Protocol& protocol);

/// "texts.consent: no font here has あ (U+3042), shown as a question mark; install ...".
/// Without the name of the file.
std::string warning_of(const MissingLetters& missing);

/// Says so on standard error, a line for each text.
void warn_of_missing_letters(const Protocol& protocol);

}  // namespace foveola::study
