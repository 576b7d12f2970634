// A display's view of the sphere, from its profile and the window's size, and the preview window's
// zoom.
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
  double horizontal_fov_deg = 0.0;  ///< of one view, without the lens
  double vertical_fov_deg = 0.0;
  RadialLens lens;                                 ///< of the first part
  Quat turned{1.0F, 0.0F, 0.0F, 0.0F};             ///< orientation of the views in the head
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< of a view; null: the whole view
  std::vector<WindowPart> parts;  ///< one, or a headset's left and right eye in a window

  /// Of the first part.
  FieldOfView field_of_view() const {
    return {.horizontal_deg = horizontal_fov_deg,
            .vertical_deg = vertical_fov_deg,
            .lens = lens,
            .seen = seen};
  }
};

/// A monitor's window has the true angles of a pane of its size at the viewing distance. A headset
/// shows its whole view to each eye, however large the window. By OpenXR it is the view that holds
/// both eyes' views, in a picture of one eye's size. framebuffer: pixels, at least 2x1.
ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer);

/// The same for a monitor's window whose larger side spans larger_fov_deg, in (0, 180), whatever
/// its size and the eye's place. A headset's is view_geometry.
ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer,
                           double larger_fov_deg);

/// The field of view across the larger side of the first part.
double larger_fov_deg(const ViewGeometry& geometry);

/// Ratio of a view's width to its true width, on a plane at distance 1.
double widening(const ViewGeometry& geometry, const ViewGeometry& true_angles);

/// The views of a head, one per part.
std::vector<Viewport> viewports_of(const ViewGeometry& geometry, const Quat& head);

/// The direction in the head's axes of a place in the window, in pixels from its top left corner.
Vec3 direction_below(const ViewGeometry& geometry, const DVec2& place, int framebuffer_height);

/// A window's view with zoom. A headset's views are always its profile's.
class WindowView {
 public:
  /// Limits of zooming across the window's larger side, in degrees.
  static constexpr double narrowest_fov_deg = 5.0;
  static constexpr double widest_fov_deg = 120.0;

  /// larger_fov_deg: across the larger side of a monitor's window, in (0, 180); nullopt: true
  /// angles for an eye at the profile's distance. framebuffer: pixels, at least 2x1.
  WindowView(const DisplayProfile& display, std::optional<double> larger_fov_deg,
             const IVec2& framebuffer);

  /// Keeps the field of view of the larger side.
  void resize(const IVec2& framebuffer);
  /// Zooms in by this number of steps, of a tenth each, or out if negative, within the limits.
  void zoom(double steps);
  /// Restores the initial view, or 60 degrees if that had true angles.
  void show_first();
  void show_true_angles();
  /// Shows true angles while eyes are measured, whatever the choice.
  void measure_eyes(bool measures);

  const ViewGeometry& geometry() const { return geometry_; }
  /// Ratio of its width to the true width: see widening().
  double times_true() const { return widening(geometry_, true_angles_); }
  /// Whether the user can choose it.
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
