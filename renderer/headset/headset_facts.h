// What is known of a headset once it is there, and its profile.
#pragma once

#include <array>
#include <string>

#include "renderer/base/angles.h"
#include "renderer/base/clock.h"
#include "renderer/gaze/profiles.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// What a headset's runtime tells of it.
struct HeadsetFacts {
  std::string runtime;                   ///< as "Monado 25.0.0"
  std::string headset;                   ///< its name
  bool has_eye_tracker = false;          ///< one that programs may ask
  std::array<IVec2, 2> eye_px{};         ///< of the pictures for the left eye and the right eye
  std::array<FieldOfView, 2> eyes;       ///< what each sees
  std::array<Quat, 2> head_from_eyes{};  ///< how each is turned in the head
  FieldOfView both;  ///< what holds both, in the head's axes, and what of it is seen at first
  double refresh_rate_hz = 0.0;
  /// From when the runtime asks for a frame until the middle of when it is to be seen.
  Nanoseconds display_delay{0};

  /// How far an eye is turned outwards in the head.
  double cant_deg(std::size_t eye) const {
    const Vec3 ahead = head_from_eyes[eye] * Vec3(0.0F, 0.0F, -1.0F);
    const double right_deg = degrees(azimuth_elevation(ahead).azimuth_rad);
    return eye == 0 ? -right_deg : right_deg;
  }
};

/// `profile`, of the kind openxr, with what it does not say itself: the views, the rate, and the
/// time until a frame is seen. Its size is that of one eye's picture.
DisplayProfile told_by(const HeadsetFacts& facts, DisplayProfile profile);

}  // namespace foveola
