// Chooses one of many lights by its potential contribution to a shading point.
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

/// A chosen light and its probability.
struct ChosenLight {
  std::size_t light;
  float probability;
};

/// A tree over lights with up to eight children per node (Conty Estevez and Kulla 2018, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting"; Pharr et al., Physically Based Rendering,
/// 4th ed., section 12.6.3). Sampling descends from the root and chooses children in proportion to
/// their bounds' contribution. A light that reaches the shading point never has probability 0.
class LightTree {
 public:
  /// One element per light; lights of intensity 0 are never drawn. At most 2^30 lights, of which at
  /// least one has intensity.
  explicit LightTree(std::span<const LightBounds> lights);

  static constexpr std::size_t width = 8;
  using Lanes = std::array<float, width>;

  /// Factors on the importance of the children of the root and of the nodes next to it, for
  /// knowledge beyond the lights' bounds. Positive and finite.
  static constexpr std::size_t preferring_nodes = 1 + width;
  using Preferences = std::array<Lanes, preferring_nodes>;

  /// u in [0, 1). preferences: or null. nullopt if no light can reach the shading point, or if the
  /// descent ends without one.
  std::optional<ChosenLight> sample(const ShadingPoint& shading_point, double u,
                                    const Preferences* preferences = nullptr) const;

  /// Probability that sample() draws this light.
  float probability(const ShadingPoint& shading_point, std::size_t light,
                    const Preferences* preferences = nullptr) const;

  /// Calls visit(node, child) for the preferring nodes on the path to a light that can be drawn.
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
  /// The children's bounds as the importance needs them, side by side for processing in parallel.
  struct alignas(32) Node {
    std::array<Lanes, 3> centre{};
    Lanes radius{};
    std::array<Lanes, 3> axis{};
    Lanes spread_cosine{};
    Lanes spread_sine{};
    Lanes falloff_cosine{};
    Lanes intensity{};  ///< relative to that of all children; 0 for absent children
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

  /// Proportional to bounds on the contribution of each child's lights to the shading point; 0 only
  /// for children that cannot reach it.
  static Lanes importance(const Node& node, const ShadingPoint& shading_point);
  /// The importance times the preferences.
  Lanes weights(std::uint32_t node, const ShadingPoint& shading_point,
                const Preferences* preferences) const;

  std::vector<Node> nodes_;  ///< breadth first, from the root
  std::vector<Place> parent_of_node_;
  std::vector<Place> leaf_of_light_;  ///< nowhere: never drawn
};

}  // namespace foveola
