// Finds characters of a protocol's texts that no installed font has, before a session begins.
#pragma once

#include <string>
#include <vector>

#include "renderer/window/screens/screen_fonts.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// A text that participants read, and its key in the protocol: "texts.consent",
/// "questionnaire.background.age".
struct ShownText {
  std::string key;
  std::string words;
};

/// Returns all texts of the protocol itself, without the built-in ones.
std::vector<ShownText> shown_texts(const Protocol& protocol);

struct MissingLetters {
  std::string key;
  Characters characters;
};

/// Returns an entry for each text with characters that would be shown as question marks.
std::vector<MissingLetters> missing_letters(const Protocol& protocol);

/// Returns "texts.consent: no font here has あ (U+3042), shown as a question mark; install ...",
/// without the name of the protocol's file.
std::string warning_of(const MissingLetters& missing);

/// Prints the warnings on standard error, a line per text.
void warn_of_missing_letters(const Protocol& protocol);

}  // namespace foveola::study
