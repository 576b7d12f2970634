#include "renderer/gaze/screen.h"

#include <cmath>

#include "renderer/base/angles.h"

namespace foveola {

Vec3 direction_at(const Screen& screen, const DVec2& fraction) {
  const double right = std::tan(radians(0.5 * screen.horizontal_fov_deg));
  const double up = std::tan(radians(0.5 * screen.vertical_fov_deg));
  return Vec3(
      glm::normalize(DVec3((2.0 * fraction.x - 1.0) * right, (1.0 - 2.0 * fraction.y) * up, -1.0)));
}

DVec2 fraction_of(const Screen& screen, const DVec2& metres) {
  return {metres.x / screen.width_m, metres.y / screen.height_m};
}

}  // namespace foveola
