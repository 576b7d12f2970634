#include "renderer/progressive/picture.h"

#include <algorithm>
#include <cmath>

namespace foveola {
namespace {

IVec2 fitted_size(double aspect_ratio) {
  const IVec2 most = usual_picture_size;
  const int width = static_cast<int>(std::lround(std::min<double>(most.x, most.y * aspect_ratio)));
  const int height = static_cast<int>(std::lround(std::min<double>(most.y, most.x / aspect_ratio)));
  return glm::max(IVec2(width, height), IVec2(1));
}

}  // namespace

Picture picture_of(const CameraView& camera, const PictureChoices& choices) {
  Picture picture;
  picture.size = choices.size.value_or(camera.aspect_ratio ? fitted_size(*camera.aspect_ratio)
                                                           : usual_picture_size);
  const double height_by_width = static_cast<double>(picture.size.y) / picture.size.x;
  FieldOfView& fov = picture.field_of_view;
  if (choices.horizontal_fov_deg) {
    fov.horizontal_deg = *choices.horizontal_fov_deg;
  } else if (camera.vertical_fov_rad) {
    fov.horizontal_deg = fov_across_deg(1.0 / height_by_width, degrees(*camera.vertical_fov_rad));
  } else {
    fov.horizontal_deg =
        fov_across_deg(std::min(1.0, 1.0 / height_by_width), usual_picture_fov_deg);
  }
  fov.vertical_deg =
      choices.vertical_fov_deg.value_or(fov_across_deg(height_by_width, fov.horizontal_deg));
  return picture;
}

Viewport viewport_of(const CameraView& camera, const FieldOfView& field_of_view) {
  // Clockwise as the camera sees it is a negative turn about +Z, which points back.
  const Quat roll = glm::angleAxis(static_cast<float>(-camera.roll_rad), Vec3(0.0F, 0.0F, 1.0F));
  return Viewport(head_orientation(camera.heading) * roll, radians(field_of_view.horizontal_deg),
                  radians(field_of_view.vertical_deg), field_of_view.lens);
}

float pixel_angle_rad(const Picture& picture) {
  const double half_width = std::tan(0.5 * radians(picture.field_of_view.horizontal_deg));
  return static_cast<float>(2.0 * half_width / picture.size.x);
}

}  // namespace foveola
