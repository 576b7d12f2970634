// What a display shows of the sphere, by its profile and the size of the window on it, and how wide
// the preview's window shows the scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gaze/profiles.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/view_renderer.h"

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

/// A headset's views are always as its profile has them.
class WindowView {
 public:
  /// Across the window's larger side, in degrees: what zooming reaches.
  static constexpr double narrowest_fov_deg = 5.0;
  static constexpr double widest_fov_deg = 120.0;

  /// larger_fov_deg: across the larger side of a monitor's window, in (0, 180); empty: true angles,
  /// as they are where the eye is at the profile's distance. framebuffer: pixels, at least 2x1.
  WindowView(const DisplayProfile& display, std::optional<double> larger_fov_deg,
             const IVec2& framebuffer);

  /// Keeps what the larger side shows.
  void resize(const IVec2& framebuffer);
  /// Narrows the view so many steps, of a tenth each, or widens it, within the limits.
  void zoom(double steps);
  /// Back to what it began with, or 60 degrees if that was true angles.
  void show_first();
  void show_true_angles();
  /// Shows true angles for as long as eyes are measured, whatever was chosen.
  void measure_eyes(bool measures);

  const ViewGeometry& geometry() const { return geometry_; }
  /// How many times as wide as true angles: see widening().
  double times_true() const { return widening(geometry_, true_angles_); }
  /// Whether it can be chosen.
  bool is_free() const { return display_.kind == DisplayKind::monitor; }
  /// "view 60.0 x 36.0 degrees, 2.2 times as wide as true".
  std::string in_words() const;

 private:
  void update();

  DisplayProfile display_;
  std::optional<double> first_fov_deg_;
  std::optional<double> larger_fov_deg_;
  bool measures_ = false;
  IVec2 framebuffer_;
  ViewGeometry true_angles_;
  ViewGeometry geometry_;
};

}  // namespace foveola
