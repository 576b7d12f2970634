// Where the tables of albedos have their nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace foveola {

/// Alpha of the tables' first rows, so small that albedos depend on cosine / alpha only.
constexpr float vanishing_alpha = 1e-5F;

/// A cosine's position in [0, 1] on the tables' axis. Where masking sets in, at cosines around
/// alpha, positions lie dense.
inline float albedo_position(float cosine, float alpha) {
  constexpr float no_zero = std::numeric_limits<float>::min();
  return 0.65F * std::sqrt(cosine * (1.0F + alpha) / (cosine + alpha + no_zero)) + 0.35F * cosine;
}

/// The cosine at node `node` of steps + 1, by bisection; never zero.
inline float cosine_of_node(std::size_t node, int steps, float alpha) {
  const float wanted = static_cast<float>(node) / static_cast<float>(steps);
  float below = 0.0F;
  float above = 1.0F;
  for (int i = 0; i < 40; ++i) {
    const float middle = 0.5F * (below + above);
    (albedo_position(middle, alpha) < wanted ? below : above) = middle;
  }
  return std::max(above, 1e-7F * alpha);
}

/// A position among nodes: the one below, and how far it is to the next.
struct NodePosition {
  int below;
  float fraction;

  NodePosition(float unit, int steps)
      : below(std::min(static_cast<int>(unit * static_cast<float>(steps)), steps - 1)),
        fraction(unit * static_cast<float>(steps) - static_cast<float>(below)) {}
};

}  // namespace foveola
