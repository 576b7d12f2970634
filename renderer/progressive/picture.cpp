#include "renderer/progressive/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foveola {
namespace {

IVec2 fitted_size(double aspect_ratio) {
  const IVec2 most = default_picture_size;
  const int width = static_cast<int>(std::lround(std::min<double>(most.x, most.y * aspect_ratio)));
  const int height = static_cast<int>(std::lround(std::min<double>(most.y, most.x / aspect_ratio)));
  return glm::max(IVec2(width, height), IVec2(1));
}

/// Share of the picture, each way, that the content fills.
constexpr double filled = 0.9;

double half_extent(double fov_deg) { return filled * std::tan(0.5 * radians(fov_deg)); }

}  // namespace

Picture picture_of(const CameraView& camera, const PictureChoices& choices) {
  Picture picture;
  picture.size = choices.size.value_or(camera.aspect_ratio ? fitted_size(*camera.aspect_ratio)
                                                           : default_picture_size);
  const double height_by_width = static_cast<double>(picture.size.y) / picture.size.x;
  FieldOfView& fov = picture.field_of_view;
  if (choices.horizontal_fov_deg) {
    fov.horizontal_deg = *choices.horizontal_fov_deg;
  } else if (camera.vertical_fov_rad) {
    fov.horizontal_deg = fov_across_deg(1.0 / height_by_width, degrees(*camera.vertical_fov_rad));
  } else {
    fov.horizontal_deg =
        fov_across_deg(std::min(1.0, 1.0 / height_by_width), default_picture_fov_deg);
  }
  fov.vertical_deg =
      choices.vertical_fov_deg.value_or(fov_across_deg(height_by_width, fov.horizontal_deg));
  return picture;
}

Viewport viewport_of(const CameraView& camera, const FieldOfView& field_of_view) {
  // Clockwise for the camera is a negative rotation about +Z, which points back.
  const Quat roll = glm::angleAxis(static_cast<float>(-camera.roll_rad), Vec3(0.0F, 0.0F, 1.0F));
  return Viewport(head_orientation(camera.heading) * roll, radians(field_of_view.horizontal_deg),
                  radians(field_of_view.vertical_deg), field_of_view.lens);
}

float pixel_angle_rad(const Picture& picture) {
  const double half_width = std::tan(0.5 * radians(picture.field_of_view.horizontal_deg));
  return static_cast<float>(2.0 * half_width / picture.size.x);
}

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
// side . p <= side . c; likewise for the other sides. Two opposite sides in equality give the place
// along their axis and the minimum distance; the larger of the two distances serves both.
Vec3 Framing::position() const {
  const double across = 0.5 * (furthest_[0] - furthest_[1]);
  const double upwards = 0.5 * (furthest_[2] - furthest_[3]);
  const double distance = std::max(0.5 * (furthest_[0] + furthest_[1]) / half_size_.x,
                                   0.5 * (furthest_[2] + furthest_[3]) / half_size_.y);
  return Vec3(across * right_ + upwards * up_ + distance * back_);
}

}  // namespace foveola
