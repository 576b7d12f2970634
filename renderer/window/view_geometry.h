// What a display shows of the sphere: by its profile and the size of the window on it.
#pragma once

#include <memory>
#include <vector>

#include "renderer/gaze/profiles.h"
#include "renderer/view/viewport.h"
#include "renderer/window/view_renderer.h"

namespace foveola {

struct ViewGeometry {
  double horizontal_fov_deg = 0.0;  ///< one view's, without the lens
  double vertical_fov_deg = 0.0;
  RadialLens lens;                                 ///< before the first part
  Quat turned{1.0F, 0.0F, 0.0F, 0.0F};             ///< how the views are turned in the head
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< of a view; null: all of it
  std::vector<WindowPart> parts;  ///< one, or a headset's left eye's and right eye's in a window

  /// The first part's.
  FieldOfView field_of_view() const {
    return {.horizontal_deg = horizontal_fov_deg,
            .vertical_deg = vertical_fov_deg,
            .lens = lens,
            .seen = seen};
  }
};

/// A monitor's window shows what a pane of that size would let through at the viewing distance, so
/// that angles are true; a headset shows its whole view to each eye, however large the window. By
/// OpenXR it is what holds both eyes' views, in a picture of the size of one.
/// framebuffer: pixels, at least 2x1.
ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer);

/// The same of a monitor's window whose larger side shows so many degrees, in (0, 180), however
/// large it is and wherever the eye is. A headset's is view_geometry.
ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer,
                           double larger_fov_deg);

/// The field of view across the larger side of the first part.
double larger_fov_deg(const ViewGeometry& geometry);

/// How many times wider a window's view is than its true angles: their widths on a plane at
/// distance 1, compared.
double widening(const ViewGeometry& geometry, const ViewGeometry& true_angles);

/// The views of a head, one for each part.
std::vector<Viewport> viewports_of(const ViewGeometry& geometry, const Quat& head);

/// The direction in the head's axes of a place in the window, in pixels from its top left corner.
Vec3 direction_below(const ViewGeometry& geometry, const DVec2& place, int framebuffer_height);

}  // namespace foveola
