// How wide the preview's window shows the scene: at true angles, or as its user likes.
#pragma once

#include <optional>
#include <string>

#include "renderer/window/view_geometry.h"

namespace foveola {

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
