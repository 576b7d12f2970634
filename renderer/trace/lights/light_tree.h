// Drawing one of many lights by how much of its light a place may receive.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// A light that was drawn, and the probability with which it was.
struct ChosenLight {
  std::size_t light;
  float probability;
};

/// A tree over lights with up to eight children a node (Conty Estevez and Kulla 2018, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting"; Pharr et al., Physically Based Rendering,
/// 4th ed., section 12.6.3). A draw goes down from the root and at each node prefers the children
/// whose bounds let them give more. A light that reaches the shading point is never given the
/// probability 0.
class LightTree {
 public:
  /// One element a light; those of intensity 0 are never drawn. At most 2^30 lights, not all of
  /// them without intensity.
  explicit LightTree(std::span<const LightBounds> lights);

  static constexpr std::size_t width = 8;
  using Lanes = std::array<float, width>;

  /// The nodes next to the root, and itself, at which something may be known that the lights'
  /// bounds do not say: what each child's importance is to be multiplied by, positive and finite.
  static constexpr std::size_t preferring_nodes = 1 + width;
  using Preferences = std::array<Lanes, preferring_nodes>;

  /// u in [0, 1). Empty if no light can reach the shading point, or that turned out on the way
  /// down. preferences: or null.
  std::optional<ChosenLight> sample(const ShadingPoint& shading_point, double u,
                                    const Preferences* preferences = nullptr) const;

  /// With which probability sample() draws this light.
  float probability(const ShadingPoint& shading_point, std::size_t light,
                    const Preferences* preferences = nullptr) const;

  /// Calls visit(node, child) for the preferring nodes on the way to a light that can be drawn.
  template <typename Visit>
  void for_each_preference(std::size_t light, const Visit& visit) const {
    for (Place place = leaf_of_light_[light]; place.node != nowhere;
         place = parent_of_node_[place.node]) {
      if (place.node < preferring_nodes) {
        visit(std::size_t{place.node}, std::size_t{place.lane});
      }
    }
  }

 private:
  /// What the importance needs of each child's lights, side by side so that the processor works on
  /// all children at once.
  struct alignas(32) Node {
    std::array<Lanes, 3> centre{};
    Lanes radius{};
    std::array<Lanes, 3> axis{};
    Lanes spread_cosine{};
    Lanes spread_sine{};
    Lanes falloff_cosine{};
    Lanes intensity{};  ///< over that of all children; 0 where there is no child
    std::array<std::uint32_t, width> is_two_sided{};
    std::array<std::uint32_t, width> child{};  ///< a node, or a light with `leaf_flag`
  };
  static constexpr std::uint32_t leaf_flag = 1U << 31U;

  /// A node's lane.
  struct Place {
    std::uint32_t node = nowhere;
    std::uint32_t lane = 0;
  };
  static constexpr std::uint32_t nowhere = ~0U;
  class Builder;

  /// Proportional to bounds on what the lights below each child may give to the shading point; 0
  /// only where none of them reaches it.
  static Lanes importance(const Node& node, const ShadingPoint& shading_point);
  /// The same with what is preferred.
  Lanes weights(std::uint32_t node, const ShadingPoint& shading_point,
                const Preferences* preferences) const;

  std::vector<Node> nodes_;  ///< the root first, then its children, and then theirs
  std::vector<Place> parent_of_node_;
  std::vector<Place> leaf_of_light_;  ///< nowhere: never drawn
};

}  // namespace foveola
