// Participants' codes, which are never names.
#pragma once

#include <string>

#include <fmt/format.h>

namespace foveola::study {

/// Returns "P001" for index 0.
inline std::string participant_code(int participant_index) {
  return fmt::format("P{:03}", participant_index + 1);
}

}  // namespace foveola::study
