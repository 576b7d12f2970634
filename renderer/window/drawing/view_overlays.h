// What is drawn over the film, by the directions that it marks: the gaze, rings of acuity, sample
// densities, what is offered, and points to look at.
#pragma once

#include <optional>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/view_renderer.h"

struct ImDrawList;
namespace foveola {

/// Densities over a view, row by row from its top left, 0 the least and 1 the most.
struct DensityMap {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// The sampler's density by its logarithm: 0 at a hundredth of what a uniform sampler of the sphere
/// has, 1 at a hundred times that.
DensityMap density_map(const ViewSampler& sampler, const Viewport& viewport, int width, int height);

/// The colour, sRGB in [0, 1], of a map's value: from blue for 0 over green to red for 1.
Rgb density_color(float value);

/// A ring that offers what is in it. If a view does not show the highlighted one's middle, an arrow
/// says where to turn.
struct OfferRing {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< direction of its middle; unit length, world
  float radius_rad = 0.0F;
  bool is_highlighted = false;  ///< the one that is chosen by now
};

/// What is drawn over the film, each on demand.
struct ViewOverlays {
  Vec3 gaze{0.0F, 0.0F, -1.0F};  ///< unit length, world
  bool shows_gaze = false;       ///< whether the gaze is drawn, as a point
  std::vector<float> rings_rad;  ///< eccentricities of rings around it, which say how many degrees
  std::optional<DensityMap> density;
  std::optional<Vec3> target;     ///< a point to look at instead of the film; unit length, world
  float least_target_px = 0.0F;   ///< the radius that the target has at least
  std::vector<OfferRing> offers;  ///< of overlapping ones the last is on top
};

/// A view and the part of the window that it fills.
struct ShownView {
  Viewport viewport;
  WindowPart part;
  /// In a headset: where what is straight ahead of the head is in the part, whose top left corner
  /// is (0, 0) and whose bottom right one (1, 1). Empty on a monitor.
  std::optional<Vec2> straight_ahead;
  /// Where pages stand in the world: maps homogeneous places on a canvas like the part, which both
  /// eyes see, to those at which this eye sees them. Empty where pages are drawn on the part
  /// itself.
  std::optional<Mat3> part_from_canvas;
};

/// Paints them into the view's part of a window that is so many pixels high, in the window's
/// pixels.
void paint(ImDrawList& list, const ViewOverlays& overlays, const ShownView& view,
           int framebuffer_height);

}  // namespace foveola
