// An ordinary picture of a scene, as a camera with a flat sensor makes it: its size and its view.
#pragma once

#include <optional>

#include "renderer/scene/scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// The larger side of what a picture shows where neither the camera nor the user says it. About
/// what a lens of 31 mm shows in front of a sensor 36 mm wide.
inline constexpr double usual_picture_fov_deg = 60.0;

/// A picture has at most so many pixels each way unless the user gives its size.
inline constexpr IVec2 usual_picture_size{1280, 720};

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

}  // namespace foveola
