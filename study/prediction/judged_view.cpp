#include "study/prediction/judged_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// A square view around `middle` that shows radius_rad to all sides.
JudgedView view_around(const Vec3& middle, double radius_rad, double pixel_rad,
                       std::shared_ptr<const Cells> cells) {
  constexpr double widest_rad = 1.4;
  const double half_size = std::tan(std::min(radius_rad, widest_rad));
  const auto side = static_cast<int>(std::ceil(2.0 * half_size / pixel_rad));
  // As many whole pixels as are at least needed, each of the size of the display's.
  const double fov_rad = 2.0 * std::atan(0.5 * side * pixel_rad);
  const Viewport viewport(head_orientation(azimuth_elevation(middle)), fov_rad, fov_rad);
  CellPixels pixels = pixels_of(*cells, viewport, side, side);
  return {.viewport = viewport,
          .width = side,
          .height = side,
          .cells = std::move(cells),
          .pixels = std::move(pixels),
          .with_contrast = false};
}

/// Cells are squares: a corner lies beyond the radius that the middles are in.
double reach_rad(double radius_deg, const Cells& cells) {
  return radians(radius_deg + std::numbers::sqrt2 * cells.cell_deg());
}

/// The angle of a pixel in the middle of the display.
double display_pixel_rad(const DisplaySettings& display) {
  const Viewport view(head_orientation({}), radians(display.horizontal_fov_deg),
                      radians(display.vertical_fov_deg), display.lens);
  const Vec2 middle(0.5F);
  const double sr =
      view.sr_per_area(middle) / (static_cast<double>(display.view_width) * display.view_height);
  return std::sqrt(sr);
}

JudgedView display_view(const OfferedObject& object, const DisplaySettings& display,
                        const Cells& cells) {
  const Viewport viewport = aim_at(object.direction, display).viewport;
  return {.viewport = viewport,
          .width = display.view_width,
          .height = display.view_height,
          .cells = std::make_shared<const Cells>(cells),
          .pixels = pixels_of(cells, viewport, display.view_width, display.view_height),
          .with_contrast = false};
}

}  // namespace

Aim aim_at(const Vec3& object, const DisplaySettings& display) {
  const Viewport viewport(head_orientation(azimuth_elevation(object)),
                          radians(display.horizontal_fov_deg), radians(display.vertical_fov_deg),
                          display.lens);
  return {.viewport = viewport, .gaze = object, .pointer = std::nullopt};
}

JudgedView view_of_outline(const Vision& vision, const OfferedObject& object,
                           const DisplaySettings& display) {
  JudgedView view =
      display_view(object, display, outline_cells(vision, object.direction, object.radius_deg));
  view.with_contrast = true;
  return view;
}

JudgedView view_of_material(const Vision& vision, const OfferedObject& object,
                            const DisplaySettings& display) {
  return display_view(object, display, material_cells(vision, object.direction, object.radius_deg));
}

std::vector<JudgedView> views_around(const Vision& vision, const DisplaySettings& display) {
  const double pixel_rad = display_pixel_rad(display);
  constexpr double smallest_radius_deg = 1.0;
  constexpr double blocks_to_each_side = 0.8;  // a whole block, wherever the grid begins
  const int block = std::max(1, static_cast<int>(std::lround(vision.coarseness)));
  const double block_deg = block * vision.view_cell_deg;
  const double radius_deg = std::max(smallest_radius_deg, blocks_to_each_side * block_deg);
  const Cells everywhere = view_cells(vision);
  std::vector<JudgedView> views;
  for (const Cells::Patch& patch : everywhere.patches()) {
    auto cells = std::make_shared<const Cells>(Cells::around(
        patch.direction, radius_deg, vision.view_cell_deg, vision.view_patch_deg, block));
    const double reach = reach_rad(radius_deg, *cells);
    views.push_back(view_around(patch.direction, reach, pixel_rad, std::move(cells)));
  }
  return views;
}

}  // namespace foveola::study
