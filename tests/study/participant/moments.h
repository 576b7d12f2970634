// The mean and the deviation of what is drawn.

#pragma once

#include <cmath>
#include <cstdint>

namespace foveola::study {

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

/// Of `draw`'s values for 0, 1, ..., `count` - 1.
template <typename Draw>
Moments moments(std::uint32_t count, const Draw& draw) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double value = draw(i);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {.mean = mean, .deviation = std::sqrt(squares / count - mean * mean)};
}

}  // namespace foveola::study
