// What participants are called: codes, never names.
#pragma once

#include <string>

#include <fmt/format.h>

namespace foveola::study {

/// "P001" for index 0.
inline std::string participant_code(int participant_index) {
  return fmt::format("P{:03}", participant_index + 1);
}

}  // namespace foveola::study
