// Parts of a scene's surfaces, in each of which points are near each other and face about the same
// way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A tree of halvings, of all space and all normals (Bentley 1975, "Multidimensional Binary Search
/// Trees"), so that every point is in a region.
class SurfaceRegions {
 public:
  struct Place {
    Vec3 position;
    Vec3 normal;  ///< unit length
  };

  /// A single region.
  SurfaceRegions() = default;
  /// So many that each holds at least `fewest` of the places, if no two are the same.
  SurfaceRegions(std::vector<Place> places, std::size_t fewest);

  std::size_t count() const { return std::size_t{1} << levels_; }

  /// Below count(). Numbers that are not finite are in some region.
  std::uint32_t region_of(const Place& place) const;

  /// The same for eight points.
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const;

 private:
  static constexpr std::size_t axes = 6;  ///< the position's, then the normal's
  struct Halving {
    std::uint32_t axis = 0;
    float border = 0.0F;  ///< the least of the upper half
  };
  class Builder;

  unsigned levels_ = 0;
  std::vector<Halving> halvings_;  ///< the children of i at 2 i + 1 and 2 i + 2
};

}  // namespace foveola
