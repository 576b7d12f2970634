// Directional albedo of a rough surface's first bounce. The lost share is compensated for metals;
// light that a coat does not reflect goes to the layer below. Also the axes of such tables.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/base/work/parallel.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"

namespace foveola {

/// Alpha of the tables' first rows, so small that albedos depend only on cosine / alpha.
constexpr float vanishing_alpha = 1e-5F;

/// A cosine's position in [0, 1] on the tables' axis; of a number, or of lanes of them. Positions
/// are dense at cosines around alpha, where masking sets in.
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

/// The node below a position, and the fraction of the way to the next node. NaN lies at the first
/// node. Number: float, or Floats.
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

/// A directional albedo of the GGX lobe for any Schlick Fresnel: f0 (white - grazing) + f90
/// grazing. Number: float, or Floats.
template <typename Number>
struct SchlickAlbedoOf {
  Number white;    ///< with a Fresnel reflectance of 1
  Number grazing;  ///< with Schlick's weight for the Fresnel reflectance

  Number with(const Number& f0, const Number& f90) const {
    return f0 * (white - grazing) + f90 * grazing;
  }
};
using SchlickAlbedo = SchlickAlbedoOf<float>;
using SchlickAlbedos = SchlickAlbedoOf<Floats>;

/// Perceptual roughnesses, in [0, 1].
struct RoughnessInterval {
  float least = 0.0F;
  float most = 1.0F;
};

/// The albedo's table over roughness and the cosine of the direction. Within 1e-4 of the integral.
class GgxAlbedo {
 public:
  /// Computes the rows of the roughnesses in `needed`. Other rows must not be read, except 0 (a
  /// mirror) and 1 (lanes without a lobe). All rows take 70 ms of a core.
  GgxAlbedo(std::span<const RoughnessInterval> needed, const Workers& workers);

  /// The albedo as a function of the cosine, for one roughness or for eight. Valid as long as the
  /// table.
  template <typename Number>
  class RowOf {
   public:
    /// cosine: between the normal and the direction, in [0, 1].
    SchlickAlbedoOf<Number> at(const Number& cosine) const;
    /// 2 * integral of albedo(c) c dc over [0, 1]: the albedo under a uniform sky.
    SchlickAlbedoOf<Number> mean() const;

   private:
    friend class GgxAlbedo;
    const Vec2* nodes_ = nullptr;
    const SchlickAlbedo* means_ = nullptr;
    IntOf<Number> smoother_{};    ///< the table's row below the roughness
    IntOf<Number> first_node_{};  ///< index of that row's first node
    Number alpha_{};
    Number rougher_weight_{};
  };
  using Row = RowOf<float>;
  using Rows = RowOf<Floats>;

  /// roughness: perceptual, in [0, 1]; below min_roughness, a perfect mirror.
  Row row(float roughness) const;
  /// roughness: in [min_roughness, 1].
  Rows row(const Floats& roughness) const { return rough_row(roughness); }

 private:
  template <typename Number>
  RowOf<Number> rough_row(const Number& roughness) const;
  Row mirror_row() const;
  /// Whether the row `number` is read for any of these roughnesses.
  static bool is_needed(std::size_t number, std::span<const RoughnessInterval> needed);

  static constexpr int roughness_steps = 64;
  static constexpr int cosine_steps = 96;
  static constexpr std::size_t row_count = roughness_steps + 2;
  static constexpr std::size_t nodes_in_row = cosine_steps + 1;

  /// The tabulated form of an albedo. x: the white albedo. y: the excess of the lobe's mean Schlick
  /// weight over the cosine's, divided by alpha. Both are nearly linear in the position, also for
  /// alpha towards 0.
  static Vec2 node_of(const SchlickAlbedo& albedo, float cosine, float alpha) {
    return {albedo.white, (albedo.grazing / albedo.white - schlick_weight(cosine)) / alpha};
  }
  template <typename Number>
  static SchlickAlbedoOf<Number> albedo_of(const Number& x, const Number& y, const Number& cosine,
                                           const Number& alpha) {
    return {.white = x, .grazing = x * (schlick_weight(cosine) + alpha * y)};
  }

  /// The nodes around a roughness, each around a cosine.
  template <typename Number>
  struct Cell {
    Vec2Of<Number> smoother[2];
    Vec2Of<Number> rougher[2];
  };
  /// index: the smoother node below the cosine.
  static Cell<float> cell(const Vec2* nodes, std::int32_t index) {
    const Vec2* smoother = nodes + index;
    const Vec2* rougher = smoother + nodes_in_row;
    // Number by number: GCC copies pairs through the stack.
    return {{{smoother[0].x, smoother[0].y}, {smoother[1].x, smoother[1].y}},
            {{rougher[0].x, rougher[0].y}, {rougher[1].x, rougher[1].y}}};
  }
  static Cell<Floats> cell(const Vec2* nodes, const Ints& index) {
    Cell<Floats> cells;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const Cell<float> one = cell(nodes, index[lane]);
      for (std::size_t next = 0; next < 2; ++next) {
        cells.smoother[next].x[lane] = one.smoother[next].x;
        cells.smoother[next].y[lane] = one.smoother[next].y;
        cells.rougher[next].x[lane] = one.rougher[next].x;
        cells.rougher[next].y[lane] = one.rougher[next].y;
      }
    }
    return cells;
  }

  static SchlickAlbedo mean_of_row(const SchlickAlbedo* means, std::int32_t number) {
    return means[number];
  }
  static SchlickAlbedos mean_of_row(const SchlickAlbedo* means, const Ints& number) {
    SchlickAlbedos of_lanes;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      of_lanes.white[lane] = means[number[lane]].white;
      of_lanes.grazing[lane] = means[number[lane]].grazing;
    }
    return of_lanes;
  }

  /// Row-major: first a mirror's row, then the roughnesses from 0, each over the cosine's position.
  std::vector<Vec2> nodes_;
  std::vector<SchlickAlbedo> means_;  ///< one per row
};

template <typename Number>
inline SchlickAlbedoOf<Number> GgxAlbedo::RowOf<Number>::at(const Number& cosine) const {
  const NodePositionOf<Number> place(albedo_position(cosine, alpha_), cosine_steps);
  const auto cell = GgxAlbedo::cell(nodes_, first_node_ + place.below);
  const auto between = [&](Number Vec2Of<Number>::* value) {
    const auto at_roughness = [&](std::size_t node) {
      const Number smoother = cell.smoother[node].*value;
      return smoother + rougher_weight_ * (cell.rougher[node].*value - smoother);
    };
    const Number lower = at_roughness(0);
    return lower + place.fraction * (at_roughness(1) - lower);
  };
  return albedo_of(between(&Vec2Of<Number>::x), between(&Vec2Of<Number>::y), cosine, alpha_);
}

template <typename Number>
inline SchlickAlbedoOf<Number> GgxAlbedo::RowOf<Number>::mean() const {
  const SchlickAlbedoOf<Number> smoother = mean_of_row(means_, smoother_);
  const SchlickAlbedoOf<Number> rougher = mean_of_row(means_, smoother_ + 1);
  return {.white = smoother.white + rougher_weight_ * (rougher.white - smoother.white),
          .grazing = smoother.grazing + rougher_weight_ * (rougher.grazing - smoother.grazing)};
}

template <typename Number>
inline GgxAlbedo::RowOf<Number> GgxAlbedo::rough_row(const Number& roughness) const {
  const NodePositionOf<Number> place(roughness, roughness_steps);
  RowOf<Number> row;
  row.nodes_ = nodes_.data();
  row.means_ = means_.data();
  row.smoother_ = place.below + 1;  // after the mirror's
  row.first_node_ = row.smoother_ * static_cast<std::int32_t>(nodes_in_row);
  row.alpha_ = roughness * roughness;
  row.rougher_weight_ = place.fraction;
  return row;
}

inline GgxAlbedo::Row GgxAlbedo::mirror_row() const {
  Row row;
  row.nodes_ = nodes_.data();
  row.means_ = means_.data();
  return row;
}

inline GgxAlbedo::Row GgxAlbedo::row(float roughness) const {
  assert(roughness >= 0.0F && roughness <= 1.0F);
  return roughness < min_roughness ? mirror_row() : rough_row(roughness);
}

}  // namespace foveola
