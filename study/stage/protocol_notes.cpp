#include "study/stage/protocol_notes.h"

#include <cstdio>

#include "renderer/base/print.h"
#include "renderer/base/utf8.h"

namespace foveola::study {

void print_notes(const Protocol& protocol) {
  for (const std::string& note : protocol.notes) {
    print_text(stderr, "foveola: note: {}\n", printable(note));
  }
}

}  // namespace foveola::study
