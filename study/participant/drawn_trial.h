// A trial whose times and ratings are drawn.
#pragma once

#include <cstdint>
#include <string>

namespace foveola::study {

struct DrawnTrial {
  std::uint64_t seed = 0;  ///< The participant's seed.
  int participant = 1;     ///< Number of the participant; the first is 1.
  std::string scene;
  std::string method;
  int trials_before = 0;
  std::uint32_t timing = 0;  ///< Number of the attempt; each draws a new effect of the trial.
};

}  // namespace foveola::study
