// Light probabilities per region of a scene, learned from traced paths. Next-event estimation
// learns of occlusion in no other way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/lights/light_tree.h"
#include "renderer/trace/lights/surface_regions.h"

namespace foveola {

/// A density on the unit square. Allocates no memory elsewhere, since every region has one.
class SquareWarp {
 public:
  static constexpr std::size_t width = 8;
  static constexpr std::size_t squares = width * width;

  /// The index of the square that holds a point of the unit square, row by row.
  static std::size_t square_of(const Vec2& point) { return width * step(point.y) + step(point.x); }

  /// weights: one per square, positive and finite.
  explicit SquareWarp(const std::array<double, squares>& weights) {
    double total = 0.0;
    std::array<double, width> rows{};
    for (std::size_t i = 0; i < squares; ++i) {
      total += weights[i];
      rows[i / width] += weights[i];
    }
    double above = 0.0;
    for (std::size_t row = 0; row < width; ++row) {
      double left = 0.0;
      for (std::size_t column = 0; column < width; ++column) {
        const double weight = weights[row * width + column];
        left += weight;
        columns_[row][column] = static_cast<float>(left / rows[row]);
        density_[row][column] = static_cast<float>(weight / total * squares);
      }
      above += rows[row];
      rows_[row] = static_cast<float>(above / total);
    }
  }

  struct Point {
    Vec2 place;  ///< in the unit square
    float density;
  };
  /// u: in the unit square. Neighbouring u give neighbouring points.
  Point sample(const Vec2& u) const {
    const Step row = find(rows_, u.y);
    const Step column = find(columns_[row.index], u.x);
    constexpr float side = 1.0F / static_cast<float>(width);
    const auto place = [](const Step& step) {
      return std::min((static_cast<float>(step.index) + step.within) * side, largest_below_one);
    };
    return {.place = {place(column), place(row)}, .density = density_[row.index][column.index]};
  }

  /// square: see square_of().
  float density_in(std::size_t square) const { return density_[square / width][square % width]; }
  float density(const Vec2& point) const { return density_[step(point.y)][step(point.x)]; }

 private:
  using Sums = std::array<float, width>;
  struct Step {
    std::size_t index;
    float within;  ///< in [0, 1)
  };

  static std::size_t step(float x) {
    return std::min(static_cast<std::size_t>(x * static_cast<float>(width)), width - 1);
  }
  static Step find(const Sums& sums, float u) {
    std::size_t index = 0;
    for (std::size_t i = 0; i + 1 < width; ++i) {
      index += sums[i] <= u ? 1 : 0;
    }
    const float lower = index == 0 ? 0.0F : sums[index - 1];
    return {index, std::clamp((u - lower) / (sums[index] - lower), 0.0F, largest_below_one)};
  }

  Sums rows_{};
  std::array<Sums, width> columns_{};
  std::array<Sums, width> density_{};
};

enum class LightKind : std::uint8_t { environment, suns, local, nothing };

/// Probability of drawing each kind of light; 0 for absent kinds.
struct KindProbabilities {
  float environment = 0.0F;
  float suns = 0.0F;
  float local = 0.0F;
};

/// The result of a light sample at a path's vertex, drawn before learning.
struct LightOutcome {
  ShadingPoint shading_point;
  LightKind kind;
  /// For the environment, the square of SquareWarp that the direction was drawn from. For local
  /// lights, the light's index, or `no_light`.
  std::uint32_t light;
  /// The unoccluded light's contribution to the scattered radiance; 0 if occluded.
  float gain = 0.0F;

  static constexpr std::uint32_t no_light = ~0U;
};

/// Probability tables for regions of the surfaces hit by the learning paths. Other points use a
/// region near them. Every light keeps part of its unlearned probability, so that bad learning adds
/// variance but no bias.
class LearnedLights {
 public:
  /// Without learning: one region.
  explicit LearnedLights(const KindProbabilities& usual) : kinds_(1, usual) {}

  /// usual: probabilities with which the outcomes were drawn. tree: of the local lights, or null.
  /// knows_sky: whether the environment was drawn by its brightness.
  LearnedLights(std::span<const LightOutcome> outcomes, const KindProbabilities& usual,
                const LightTree* tree, bool knows_sky);

  /// Estimated ratio of the mean squares of light samples, learned over unlearned; 1 if nothing
  /// arrived. outcomes: independent of those learned from.
  double relative_mean_square(std::span<const LightOutcome> outcomes,
                              const KindProbabilities& usual, const LightTree* tree) const;

  std::uint32_t region_of(const Vec3& position, const Vec3& normal) const {
    return regions_.count() == 1 ? 0 : regions_.region_of({position, normal});
  }
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const {
    return regions_.count() == 1 ? Uints{} : regions_.regions_of(position, normal);
  }

  const KindProbabilities& kinds(std::uint32_t region) const { return kinds_[region]; }
  /// Density of environment directions in the sampler's unit square; null: constant.
  const SquareWarp* sky(std::uint32_t region) const {
    return sky_.empty() ? nullptr : &sky_[region];
  }
  /// Null without preferences.
  const LightTree::Preferences* preferences(std::uint32_t region) const {
    return preferences_.empty() ? nullptr : &preferences_[region];
  }

 private:
  /// The unlearned over the learned probability of drawing the outcome's light.
  double relative_probability(const LightOutcome& outcome, const KindProbabilities& usual,
                              const LightTree* tree) const;

  SurfaceRegions regions_;
  std::vector<KindProbabilities> kinds_;
  std::vector<SquareWarp> sky_;
  std::vector<LightTree::Preferences> preferences_;
};

}  // namespace foveola
