// Light from infinitely far away: its radiance, and directions drawn towards where it is bright.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/base/piecewise_constant.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The map stands turned about +Y by the environment's rotation. It is interpolated bilinearly
/// between the centres of its texels, across the seam of its two sides, and is constant within half
/// a texel of the poles. Directions are drawn from cells whose corners are texel centres (so that a
/// cell is as bright as its interpolated content), uniformly within a cell in solid angle; a
/// constant environment gives uniform directions.
class EnvironmentLight {
 public:
  /// The environment must outlive this object.
  explicit EnvironmentLight(const Environment& environment);

  /// direction: unit length.
  DistantLight at(const Vec3& direction) const;

  struct Sample {
    Vec3 direction{0.0F};
    DistantLight light;
  };
  /// u: in the unit square. Neighbouring u give neighbouring directions.
  Sample sample(const Vec2& u) const;

  /// The u with which sample() draws this direction, but for rounding.
  Vec2 place_of(const Vec3& direction) const;

  /// The luminance summed over all directions, in the unit of radiance times steradian.
  double total_luminance() const { return total_luminance_; }

 private:
  /// The solid angle of each cell in a row.
  double cell_solid_angle(std::size_t row) const;
  /// The radiance at the place `within` a cell.
  Rgb radiance_in(std::size_t column, std::size_t row, const Vec2& within) const;
  float pdf_in(std::size_t row, float probability) const;

  /// Undoes the rotation, without a trip through angles: at rotation 0 nothing is rounded.
  Vec3 map_from_world(const Vec3& direction) const;

  const Environment& environment_;
  float rotation_cosine_;
  float rotation_sine_;
  double rotation_turns_;
  std::optional<PiecewiseConstant2D> cells_;  ///< empty: constant
  std::vector<double> border_sines_;          ///< sines of the elevations between the rows of cells
  std::vector<float> cells_per_sr_;           ///< in each row
  double total_luminance_;
};

}  // namespace foveola
