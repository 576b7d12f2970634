#include "renderer/window/camera_moves.h"

#include <algorithm>
#include <numbers>

#include "renderer/view/viewport.h"

namespace foveola {

Standing orbited(const Standing& standing, const Vec3& pivot, const Turn& turn) {
  constexpr double zenith_rad = 0.5 * std::numbers::pi;
  const AzimuthElevation heading{
      .azimuth_rad = wrapped_angle(standing.heading.azimuth_rad + turn.right_rad),
      .elevation_rad =
          std::clamp(standing.heading.elevation_rad + turn.up_rad, -zenith_rad, zenith_rad)};
  const Vec3 in_head =
      glm::conjugate(head_orientation(standing.heading)) * (pivot - standing.position);
  return {.position = pivot - head_orientation(heading) * in_head, .heading = heading};
}

double walking_speed(double width_m) {
  constexpr double crossing_s = 10.0;
  return width_m > 0.0 ? width_m / crossing_s : 1.0;
}

}  // namespace foveola
