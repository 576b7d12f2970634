#include "renderer/progressive/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foveola {
namespace {

/// The part of the picture, each way, that is filled.
constexpr double filled = 0.9;

double half_extent(double fov_deg) { return filled * std::tan(0.5 * radians(fov_deg)); }

}  // namespace

Framing::Framing(const AzimuthElevation& heading, const FieldOfView& field_of_view)
    : half_size_(half_extent(field_of_view.horizontal_deg),
                 half_extent(field_of_view.vertical_deg)) {
  const Quat head = head_orientation(heading);
  right_ = DVec3(head * Vec3(1.0F, 0.0F, 0.0F));
  up_ = DVec3(head * Vec3(0.0F, 1.0F, 0.0F));
  back_ = DVec3(head * Vec3(0.0F, 0.0F, 1.0F));
  sides_ = {right_ + half_size_.x * back_, -right_ + half_size_.x * back_,
            up_ + half_size_.y * back_, -up_ + half_size_.y * back_};
  furthest_.fill(-std::numeric_limits<double>::infinity());
}

void Framing::include(const Vec3& position) {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    furthest_[side] = std::max(furthest_[side], glm::dot(sides_[side], DVec3(position)));
  }
}

void Framing::include(const Scene& scene, std::uint32_t object) {
  for (const Vec3& position : scene.mesh_of(object).positions) {
    include(scene.in_world(object, position));
  }
}

void Framing::include(const Bounds& bounds) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    include({(corner & 1U) != 0 ? bounds.upper.x : bounds.lower.x,
             (corner & 2U) != 0 ? bounds.upper.y : bounds.lower.y,
             (corner & 4U) != 0 ? bounds.upper.z : bounds.lower.z});
  }
}

// A camera at c has p in view if, to the right, (p - c) . right <= half width * (c - p) . back, or
// side . p <= side . c; and so to the other sides. Two opposite sides in equality give the place
// along their axis and the least distance; the larger of the two distances holds all.
Vec3 Framing::position() const {
  const double across = 0.5 * (furthest_[0] - furthest_[1]);
  const double upwards = 0.5 * (furthest_[2] - furthest_[3]);
  const double distance = std::max(0.5 * (furthest_[0] + furthest_[1]) / half_size_.x,
                                   0.5 * (furthest_[2] + furthest_[3]) / half_size_.y);
  return Vec3(across * right_ + upwards * up_ + distance * back_);
}

}  // namespace foveola
