// Overlays on the film at directions: the gaze, rings of acuity, sample densities, offered objects,
// and targets.
#pragma once

#include <optional>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/view_renderer.h"

struct ImDrawList;
namespace foveola {

/// Densities over a view, row by row from its top left, from 0 (minimum) to 1 (maximum).
struct DensityMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// The logarithm of the sampler's density: 0 at a hundredth of the uniform density on the sphere, 1
/// at a hundred times that.
DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width, int height);

/// The colour, sRGB in [0, 1], of a map's value: from blue for 0 over green to red for 1.
Rgb density_color(float value);

/// A ring around an offered object. If the highlighted one's centre is outside a view, an arrow
/// points to it.
struct OfferRing {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< direction of its centre; unit length, world
  float radius_rad = 0.0F;
  bool is_highlighted = false;  ///< the current choice
};

/// The overlays of the film, each on demand.
struct ViewOverlays {
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world
  bool shows_gaze = false;       ///< whether the gaze is drawn as a point
  std::vector<float> rings_rad;  ///< eccentricities of rings around it, with labels in degrees
  std::optional<DensityMap> density;
  std::optional<Vec3> target;     ///< a target instead of the film; unit length, world
  float min_target_px = 0.0F;     ///< minimum radius of the target
  std::vector<OfferRing> offers;  ///< drawn in order, the last on top
};

/// A view and its part of the window.
struct ShownView {
  Viewport viewport;
  WindowPart part;
  /// In a headset: the head's straight ahead in the part, whose top left corner is (0, 0) and
  /// bottom right one (1, 1). nullopt on a monitor.
  std::optional<Vec2> straight_ahead;
  /// Maps homogeneous places on a canvas in the world, of the part's shape and seen by both eyes,
  /// to the part. nullopt if pages are drawn on the part itself.
  std::optional<Mat3> part_from_canvas;
};

/// Paints them into the view's part of a window of framebuffer_height pixels, in the window's
/// pixels.
void paint(ImDrawList& list, const ViewOverlays& overlays, const ShownView& view,
           int framebuffer_height);

}  // namespace foveola
