// Which of several lights a sample is drawn from.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "renderer/trace/alias_table.h"
#include "renderer/trace/light_tree.h"

namespace foveola {

/// Few lights are drawn by their power, from a table; many by what they may give to the shading
/// point, from a tree.
class LightChoice {
 public:
  /// The most lights that are drawn from the table. Measured in a room lit by lamps of two
  /// triangles each: the tree halves the product of time and variance with two lamps, and quarters
  /// it with eight.
  static constexpr std::size_t usual_most_in_table = 2;

  /// One power and one element of bounds a light; without power there is no intensity. Not all
  /// powers are zero.
  LightChoice(std::span<const double> powers, std::span<const LightBounds> bounds,
              std::size_t most_in_table);

  /// u: in the unit square. Empty if no light can reach the shading point. preferences: the tree's,
  /// or null.
  std::optional<ChosenLight> sample(const ShadingPoint& shading_point, const Vec2& u,
                                    const LightTree::Preferences* preferences) const;

  /// With which probability sample() draws this light.
  float probability(const ShadingPoint& shading_point, std::size_t light,
                    const LightTree::Preferences* preferences) const;

  /// Null: lights are drawn from the table.
  const LightTree* tree() const { return std::get_if<LightTree>(&method_); }

 private:
  struct Table {
    AliasTable alias;
    std::vector<float> probabilities;
  };
  std::variant<std::monostate, Table, LightTree> method_;  ///< one of the last two
};

}  // namespace foveola
