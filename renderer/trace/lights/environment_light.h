// The environment: its radiance, and directions sampled by its brightness.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/base/numbers/piecewise_constant.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The map is rotated about +Y by the environment's rotation. It is interpolated bilinearly between
/// the centres of its texels, across the seam of its two sides, and is constant within half a texel
/// of the poles. Directions are drawn from cells whose corners are texel centres, with the cells'
/// interpolated luminance. They are uniform in solid angle within a cell; a constant environment
/// gives uniform directions.
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

  /// The inverse of sample(): the u of this direction, up to rounding.
  Vec2 place_of(const Vec3& direction) const;

  /// Whether a cell of the map is at least 16 times as bright as the mean over all directions. Such
  /// cells cover less than a sixteenth of the sphere. The Sun's are 10 000 times as bright.
  bool has_bright_spots() const { return has_bright_spots_; }
  /// Whether the direction lies in one of them, with a radiance above 0 in all channels.
  bool is_bright(const Vec3& direction) const;

  /// Luminance integrated over all directions, in radiance times steradian.
  double total_luminance() const { return total_luminance_; }

 private:
  /// Solid angle of each cell in a row, in steradians.
  double cell_solid_angle(std::size_t row) const;
  /// The radiance at position `within` a cell.
  Rgb radiance_in(std::size_t column, std::size_t row, const Vec2& within) const;
  float pdf_in(std::size_t row, float probability) const;

  /// Undoes the rotation without angles: exact at rotation 0.
  Vec3 map_from_world(const Vec3& direction) const;

  const Environment& environment_;
  float rotation_cosine_;
  float rotation_sine_;
  double rotation_turns_;
  std::optional<PiecewiseConstant2D> cells_;  ///< nullopt: constant
  std::vector<double> border_sines_;          ///< sines of the elevations between the rows of cells
  std::vector<float> cells_per_sr_;           ///< per row
  double total_luminance_;
  bool has_bright_spots_ = false;
};

}  // namespace foveola
