// Partitions a scene's surfaces into regions of nearby points with similar normals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A k-d tree over all positions and normals (Bentley 1975, "Multidimensional Binary Search
/// Trees"): every point lies in a region.
class SurfaceRegions {
 public:
  struct Place {
    Vec3 position;
    Vec3 normal;  ///< unit length
  };

  /// A single region.
  SurfaceRegions() = default;
  /// As many regions as possible with at least `fewest` of the places each, if no two are equal.
  SurfaceRegions(std::vector<Place> places, std::size_t fewest);

  std::size_t count() const { return std::size_t{1} << levels_; }

  /// In [0, count()). Non-finite points lie in some region.
  std::uint32_t region_of(const Place& place) const;

  /// The same for eight points.
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const;

 private:
  static constexpr std::size_t axes = 6;  ///< position, then normal
  struct Halving {
    std::uint32_t axis = 0;
    float border = 0.0F;  ///< minimum of the upper half
  };
  class Builder;

  unsigned levels_ = 0;
  std::vector<Halving> halvings_;  ///< the children of i at 2 i + 1 and 2 i + 2
};

}  // namespace foveola
