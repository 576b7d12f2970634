#include "renderer/scene/obj/polygon.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "renderer/base/transformed.h"

namespace foveola {
namespace {

using DVec2 = glm::dvec2;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The polygon projected along the axis nearest to its normal, counter-clockwise.
std::vector<DVec2> flattened(std::span<const Vec3> corners) {
  const DVec3 normal = area_vector(corners);
  const DVec3 size = glm::abs(normal);
  const int axis = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
  const int right = (axis + 1) % 3;
  const int up = (axis + 2) % 3;
  const double turn = normal[axis] < 0.0 ? -1.0 : 1.0;
  return transformed(corners,
                     [&](const Vec3& corner) { return DVec2(turn * corner[right], corner[up]); });
}

bool are_finite(std::span<const Vec3> corners) {
  return std::ranges::all_of(corners, [](const Vec3& corner) { return is_finite(corner); });
}

/// Twice the signed area of a triangle: positive where it turns counter-clockwise.
double turn_of(const DVec2& a, const DVec2& b, const DVec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether every corner turns left and the whole turns once: then a fan covers it. A polygon that
/// turns twice, such as a pentagram, lies on both sides of a line from its first corner.
bool is_convex(const std::vector<DVec2>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const DVec2& next = corners[(i + 1) % count];
    if (!(turn_of(corners[i], next, corners[(i + 2) % count]) >= 0.0) ||
        !(turn_of(corners[0], corners[i], next) >= 0.0)) {
      return false;
    }
  }
  return true;
}

Triangles fan(std::size_t count) {
  Triangles triangles;
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    triangles.push_back({0, i, i + 1});
  }
  return triangles;
}

/// Cuts ears one by one off the ring of remaining corners.
class EarCutter {
 public:
  explicit EarCutter(const std::vector<DVec2>& corners) : corners_(corners), left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  Triangles cut() && {
    Triangles triangles;
    std::size_t at = 0;
    std::size_t refused = 0;  // in a row
    while (left_.size() > 3) {
      at %= left_.size();
      // A simple polygon always has an ear; otherwise the next corner is cut all the same.
      if (refused < left_.size() && !is_ear(at)) {
        ++at;
        ++refused;
        continue;
      }
      triangles.push_back({neighbour(at, left_.size() - 1), left_[at], neighbour(at, 1)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      refused = 0;
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::uint32_t neighbour(std::size_t at, std::size_t step) const {
    return left_[(at + step) % left_.size()];
  }

  bool is_ear(std::size_t at) const {
    const DVec2& a = corners_[neighbour(at, left_.size() - 1)];
    const DVec2& b = corners_[left_[at]];
    const DVec2& c = corners_[neighbour(at, 1)];
    if (!(turn_of(a, b, c) > 0.0)) {
      return false;
    }
    return std::ranges::none_of(left_, [&](std::uint32_t index) {
      const DVec2& p = corners_[index];
      return p != a && p != b && p != c && turn_of(a, b, p) >= 0.0 && turn_of(b, c, p) >= 0.0 &&
             turn_of(c, a, p) >= 0.0;
    });
  }

  const std::vector<DVec2>& corners_;
  std::vector<std::uint32_t> left_;
};

}  // namespace

DVec3 area_vector(std::span<const Vec3> corners) {
  const DVec3 origin(corners[0]);
  DVec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(DVec3(corners[i]) - origin, DVec3(corners[i + 1]) - origin);
  }
  return sum;
}

Triangles triangulate(std::span<const Vec3> corners) {
  if (corners.size() < 3) {
    return {};
  }
  if (corners.size() == 3 || !are_finite(corners)) {
    return fan(corners.size());
  }
  const std::vector<DVec2> flat = flattened(corners);
  if (is_convex(flat)) {
    return fan(corners.size());
  }
  if (corners.size() > max_concave_corners) {
    throw std::length_error("a polygon that is not convex has too many corners");
  }
  return EarCutter(flat).cut();
}

}  // namespace foveola
