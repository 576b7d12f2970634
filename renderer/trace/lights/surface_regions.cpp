#include "renderer/trace/lights/surface_regions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace foveola {
namespace {

/// Distance of opposite normals, in standard deviations of all positions.
constexpr float opposite_normals = 1.0F;

float coordinate(const SurfaceRegions::Place& place, std::uint32_t axis) {
  return axis < 3 ? place.position[static_cast<int>(axis)]
                  : place.normal[static_cast<int>(axis) - 3];
}

using Places = std::span<SurfaceRegions::Place>;

double deviation_along(Places places, std::uint32_t axis) {
  double sum = 0.0;
  double squares = 0.0;
  // Relative to one of them, to keep precision far from the origin.
  const double origin = coordinate(places.front(), axis);
  for (const SurfaceRegions::Place& place : places) {
    const double x = coordinate(place, axis) - origin;
    sum += x;
    squares += x * x;
  }
  const auto count = static_cast<double>(places.size());
  return std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

}  // namespace

class SurfaceRegions::Builder {
 public:
  Builder(SurfaceRegions& regions, Places places) : regions_(regions) {
    double squares = 0.0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const double deviation = deviation_along(places, axis);
      squares += deviation * deviation;
    }
    metres_per_normal_ = 0.5 * opposite_normals * std::sqrt(squares);
    halve(0, places, regions.levels_);
  }

 private:
  void halve(std::size_t node, Places places, unsigned levels) {
    if (levels == 0) {
      return;
    }
    std::size_t lower = 0;
    if (!places.empty()) {
      const std::uint32_t axis = widest_axis(places);
      const auto before = [&](const Place& a, const Place& b) {
        return coordinate(a, axis) < coordinate(b, axis);
      };
      const auto middle = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
      std::nth_element(places.begin(), middle, places.end(), before);
      const float border = border_near(places, axis, coordinate(*middle, axis));
      lower = static_cast<std::size_t>(
          std::partition(places.begin(), places.end(),
                         [&](const Place& place) { return coordinate(place, axis) < border; }) -
          places.begin());
      regions_.halvings_[node] = {.axis = axis, .border = border};
    }
    halve(2 * node + 1, places.first(lower), levels - 1);
    halve(2 * node + 2, places.subspan(lower), levels - 1);
  }

  std::uint32_t widest_axis(Places places) const {
    std::uint32_t widest = 0;
    double most = -1.0;
    for (std::uint32_t axis = 0; axis < axes; ++axis) {
      const double width = deviation_along(places, axis) * (axis < 3 ? 1.0 : metres_per_normal_);
      if (width > most) {
        most = width;
        widest = axis;
      }
    }
    return widest;
  }

  /// The median, or the next larger value if nothing is below it.
  static float border_near(Places places, std::uint32_t axis, float median) {
    float above = std::numeric_limits<float>::infinity();
    for (const Place& place : places) {
      const float x = coordinate(place, axis);
      if (x < median) {
        return median;
      }
      above = x > median ? std::min(above, x) : above;
    }
    return above;
  }

  SurfaceRegions& regions_;
  double metres_per_normal_;
};

SurfaceRegions::SurfaceRegions(std::vector<Place> places, std::size_t fewest)
    : levels_(static_cast<unsigned>(
          std::bit_width(std::max<std::size_t>(places.size() / fewest, 1)) - 1)),
      halvings_(count() - 1) {
  if (levels_ > 0) {
    Builder(*this, places);
  }
}

std::uint32_t SurfaceRegions::region_of(const Place& place) const {
  std::uint32_t node = 0;
  for (unsigned level = 0; level < levels_; ++level) {
    const Halving& halving = halvings_[node];
    node = 2 * node + 1 + (coordinate(place, halving.axis) >= halving.border ? 1U : 0U);
  }
  return node - static_cast<std::uint32_t>(halvings_.size());
}

Uints SurfaceRegions::regions_of(const Vec3s& position, const Vec3s& normal) const {
  const std::array<Floats, axes> coordinates = {position.x, position.y, position.z,
                                                normal.x,   normal.y,   normal.z};
  std::array<float, axes * lane_count> numbers;
  __builtin_memcpy(numbers.data(), coordinates.data(), sizeof(numbers));
  std::array<std::uint32_t, lane_count> nodes{};
  for (unsigned level = 0; level < levels_; ++level) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      const Halving& halving = halvings_[nodes[lane]];
      const float x = numbers[halving.axis * lane_count + lane];
      nodes[lane] = 2 * nodes[lane] + 1 + (x >= halving.border ? 1U : 0U);
    }
  }
  Uints regions;
  __builtin_memcpy(&regions, nodes.data(), sizeof(regions));
  return regions - static_cast<std::uint32_t>(halvings_.size());
}

}  // namespace foveola
