// An ordinary picture of a scene, as a camera with a flat sensor makes it: its size, its view, and
// standing back until all of something is in it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "renderer/base/angles.h"
#include "renderer/scene/scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// The larger side of what a picture shows where neither the camera nor the user says it. About
/// what a lens of 31 mm shows in front of a sensor 36 mm wide.
inline constexpr double default_picture_fov_deg = 60.0;

/// A picture has at most so many pixels each way unless the user gives its size.
inline constexpr IVec2 default_picture_size{1280, 720};

/// What a user may choose of a picture.
struct PictureChoices {
  std::optional<IVec2> size;                 ///< pixels
  std::optional<double> horizontal_fov_deg;  ///< in (0, 180)
  std::optional<double> vertical_fov_deg;    ///< in (0, 180); default: by square pixels
};

struct Picture {
  IVec2 size{0};  ///< pixels
  FieldOfView field_of_view;
};

/// The picture of `camera`. Its size is the usual one, cut down to the camera's aspect ratio; its
/// height shows the camera's vertical field of view, and its pixels are square.
Picture picture_of(const CameraView& camera, const PictureChoices& choices);

/// How `camera` sees the picture, its roll included.
Viewport viewport_of(const CameraView& camera, const FieldOfView& field_of_view);

/// The angle that a pixel in the picture's middle spans across.
float pixel_angle_rad(const Picture& picture);

/// The nearest place from which a camera that looks along `heading` with the horizon level has all
/// that was included in its picture, in the middle, with a margin around.
class Framing {
 public:
  /// field_of_view: the picture's; its lens is ignored.
  Framing(const AzimuthElevation& heading, const FieldOfView& field_of_view);

  void include(const Vec3& position);
  /// All vertices of an object.
  void include(const Scene& scene, std::uint32_t object);
  /// The eight corners.
  void include(const Bounds& bounds);

  /// Where the camera stands; meaningless before anything was included.
  Vec3 position() const;

 private:
  DVec3 right_, up_, back_;
  std::array<DVec3, 4> sides_;      ///< normals of the pyramid of view, outwards; of no unit length
  std::array<double, 4> furthest_;  ///< the furthest that was included, along each of them
  DVec2 half_size_;                 ///< of the picture without its margin, at distance 1
};

}  // namespace foveola
