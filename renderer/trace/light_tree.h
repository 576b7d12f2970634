// Drawing one of many lights by how much of its light a place may receive.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/trace/light_bounds.h"
#include "renderer/trace/receiver.h"

namespace foveola {

/// A light that was drawn, and the probability with which it was.
struct ChosenLight {
  std::size_t light;
  float probability;
};

/// A binary tree over lights (Conty Estevez and Kulla 2018, "Importance Sampling of Many Lights
/// with Adaptive Tree Splitting"; Pharr et al., Physically Based Rendering, 4th ed., section
/// 12.6.3). A draw goes down from the root and at each node prefers the child whose bounds let it
/// give more. A light that reaches the receiver is never given the probability 0.
class LightTree {
 public:
  /// One element a light; those of intensity 0 are never drawn. At most 2^30 lights, not all of
  /// them without intensity.
  explicit LightTree(std::span<const LightBounds> lights);

  /// u in [0, 1). Empty if no light can reach the receiver, or that turned out on the way down.
  std::optional<ChosenLight> sample(const Receiver& receiver, double u) const;

  /// With which probability sample() draws this light.
  float probability(const Receiver& receiver, std::size_t light) const;

 private:
  /// What the importance needs of a subtree, in 48 bytes.
  struct Node {
    Vec3 centre{0.0F};
    float radius = 0.0F;
    Vec3 axis{0.0F};
    float spread_cosine = 0.0F;
    float spread_sine = 0.0F;
    float falloff_cosine = 0.0F;
    float intensity = 0.0F;
    std::uint32_t index : 30;  ///< of the light, or of the first of the two children
    std::uint32_t is_leaf : 1;
    std::uint32_t is_two_sided : 1;
  };
  class Builder;

  /// Proportional to a bound on what the lights below a node may give to the receiver; 0 only if
  /// none of them reaches it.
  static double importance(const Node& node, const Receiver& receiver);

  /// The root, an unused one, and then pairs of siblings: at 2 i and 2 i + 1.
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> parent_of_pair_;  ///< element i: of the siblings at 2 i and 2 i + 1
  std::vector<std::uint32_t> leaf_of_light_;   ///< `no_leaf`: never drawn
};

}  // namespace foveola
