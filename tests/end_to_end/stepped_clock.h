// What a preloaded stepped_clock.cpp reads.
#pragma once

#include <cstdint>

namespace foveola::test {

/// In whole seconds, since the program began.
struct ClockSteps {
  std::int64_t set_by_s = 0;  ///< the wall clock, beyond sleep
  std::int64_t asleep_s = 0;
};

}  // namespace foveola::test
