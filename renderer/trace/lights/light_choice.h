// Chooses one of several lights: by weight in constant time (Walker 1977; Vose 1991), or by a tree.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/trace/lights/light_tree.h"

namespace foveola {

class AliasTable {
 public:
  /// weights: >= 0 and finite, not all zero. Item i has probability weights[i] over their sum.
  explicit AliasTable(std::span<const double> weights);

  /// u: in the unit square.
  std::size_t sample(const Vec2& u) const {
    const auto slot = std::min(
        static_cast<std::size_t>(static_cast<double>(u.x) * static_cast<double>(slots_.size())),
        slots_.size() - 1);
    return u.y < slots_[slot].own_share ? slot : slots_[slot].alias;
  }

 private:
  struct Slot {
    float own_share = 1.0F;  ///< the rest of the slot belongs to `alias`
    std::uint32_t alias = 0;
  };
  std::vector<Slot> slots_;
};

/// Draws few lights by power, from a table; many by their potential contribution to the shading
/// point, from a tree.
class LightChoice {
 public:
  /// Maximum number of lights in the table. Measured in a room lit by lamps of two triangles each:
  /// the tree halves the product of time and variance with two lamps, and quarters it with eight.
  static constexpr std::size_t default_max_in_table = 2;

  /// One power and one bounds per light; a light without power has no intensity. Not all powers are
  /// zero.
  LightChoice(std::span<const double> powers, std::span<const LightBounds> bounds,
              std::size_t max_in_table);

  /// u: in the unit square. preferences: of the tree, or null. nullopt if no light can reach the
  /// shading point.
  std::optional<ChosenLight> sample(const ShadingPoint& shading_point, const Vec2& u,
                                    const LightTree::Preferences* preferences) const;

  /// Probability that sample() draws this light.
  float probability(const ShadingPoint& shading_point, std::size_t light,
                    const LightTree::Preferences* preferences) const;

  /// Null if lights are drawn from the table.
  const LightTree* tree() const { return std::get_if<LightTree>(&method_); }

 private:
  struct Table {
    AliasTable alias;
    std::vector<float> probabilities;
  };
  std::variant<std::monostate, Table, LightTree> method_;  ///< one of the last two
};

}  // namespace foveola
