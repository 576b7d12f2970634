// Where the tables of albedos have their nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "renderer/base/lanes.h"

namespace foveola {

/// Alpha of the tables' first rows, so small that albedos depend on cosine / alpha only.
constexpr float vanishing_alpha = 1e-5F;

/// A cosine's position in [0, 1] on the tables' axis; of a number, or of lanes of them. Where
/// masking sets in, at cosines around alpha, positions lie dense.
template <typename Number>
Number albedo_position(const Number& cosine, const Number& alpha) {
  constexpr float no_zero = std::numeric_limits<float>::min();
  return 0.65F * square_root(cosine * (1.0F + alpha) / (cosine + alpha + no_zero)) + 0.35F * cosine;
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

/// A position among nodes: the one below, and how far it is to the next. What is not a number lies
/// at the first one. Number: float, or Floats.
template <typename Number>
struct NodePositionOf {
  IntOf<Number> below;
  Number fraction;

  /// unit: in [0, 1].
  NodePositionOf(const Number& unit, int steps) {
    const Number position = unit * static_cast<float>(steps);
    below = clamped(truncated(position), steps - 1);
    fraction = position - floats_of(below);
  }
};
using NodePosition = NodePositionOf<float>;

}  // namespace foveola
