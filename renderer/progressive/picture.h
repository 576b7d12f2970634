// An ordinary picture of a scene, by a camera with a flat sensor: its size, its view, and framing
// of objects.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "renderer/base/angles.h"
#include "renderer/scene/scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// Default field of view across a picture's larger side, about that of a 31 mm lens on a sensor 36
/// mm wide.
inline constexpr double default_picture_fov_deg = 60.0;

/// Maximum default size of a picture, in pixels.
inline constexpr IVec2 default_picture_size{1280, 720};

/// The user's choices for a picture.
struct PictureChoices {
  std::optional<IVec2> size;                 ///< pixels
  std::optional<double> horizontal_fov_deg;  ///< in (0, 180)
  std::optional<double> vertical_fov_deg;    ///< in (0, 180); default: by square pixels
};

struct Picture {
  IVec2 size{0};  ///< pixels
  FieldOfView field_of_view;
};

/// The picture of `camera`. Its size is the default, cut to the camera's aspect ratio; its height
/// covers the camera's vertical field of view, and its pixels are square.
Picture picture_of(const CameraView& camera, const PictureChoices& choices);

/// The picture's view from `camera`, including roll.
Viewport viewport_of(const CameraView& camera, const FieldOfView& field_of_view);

/// The angle across a pixel in the picture's centre.
float pixel_angle_rad(const Picture& picture);

/// The nearest position of a level camera along `heading` at which everything included is in its
/// picture, centred, with a margin.
class Framing {
 public:
  /// field_of_view: the picture's; its lens is ignored.
  Framing(const AzimuthElevation& heading, const FieldOfView& field_of_view);

  void include(const Vec3& position);
  /// Includes all vertices of an object.
  void include(const Scene& scene, std::uint32_t object);
  /// Includes the eight corners.
  void include(const Bounds& bounds);

  /// The camera's position; meaningless before anything is included.
  Vec3 position() const;

 private:
  DVec3 right_, up_, back_;
  std::array<DVec3, 4> sides_;      ///< outward normals of the view pyramid, not of unit length
  std::array<double, 4> furthest_;  ///< the furthest included point along each of them
  DVec2 half_size_;                 ///< of the picture without its margin, at distance 1
};

}  // namespace foveola
