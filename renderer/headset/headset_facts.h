// Properties of a connected headset, and its profile.
#pragma once

#include <array>
#include <string>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/gaze/profiles.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// The properties that a headset's runtime reports.
struct HeadsetFacts {
  std::string runtime;                   ///< as "Monado 25.0.0"
  std::string headset;                   ///< name of the headset
  bool has_eye_tracker = false;          ///< whether it has one that programs may use
  std::array<IVec2, 2> eye_px{};         ///< picture sizes of the left and the right eye
  std::array<FieldOfView, 2> eyes;       ///< the eyes' fields of view
  std::array<Quat, 2> head_from_eyes{};  ///< the eyes' orientations in the head
  FieldOfView both;  ///< the view of both, in the head's axes, and its initially visible part
  double refresh_rate_hz = 0.0;
  /// From the runtime's request for a frame until the middle of its display.
  Nanoseconds display_delay{0};

  /// Outward rotation of an eye in the head, in degrees.
  double cant_deg(std::size_t eye) const {
    const Vec3 ahead = head_from_eyes[eye] * Vec3(0.0F, 0.0F, -1.0F);
    const double right_deg = degrees(azimuth_elevation(ahead).azimuth_rad);
    return eye == 0 ? -right_deg : right_deg;
  }
};

/// `profile`, of the kind openxr, completed with the views, the rate, and the time until a frame is
/// shown. Its size is that of one eye's picture.
DisplayProfile told_by(const HeadsetFacts& facts, DisplayProfile profile);

}  // namespace foveola
