#include "study/stage/analysable.h"

#include <cstdio>

#include <fmt/format.h>

#include "renderer/base/utf8.h"
#include "study/protocol/analysed_measures.h"

namespace foveola::study {

void require_analysable(const Protocol& protocol) {
  if (const std::vector<Error> faults = unanalysable(protocol); !faults.empty()) {
    throw faults.front();
  }
}

void warn_of_unanalysable(const Protocol& protocol) {
  for (const Error& fault : unanalysable(protocol)) {
    fmt::print(stderr, "foveola: warning: {}\n", fault.what());
  }
}

void warn_of_recorded_only(const Protocol& protocol) {
  for (const std::string& measure : recorded_only(protocol)) {
    fmt::print(stderr, "foveola: warning: {}\n", printable(measure));
  }
  for (const std::string& note : protocol.notes) {
    fmt::print(stderr, "foveola: note: {}\n", printable(note));
  }
}

}  // namespace foveola::study
