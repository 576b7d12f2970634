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
          .side = side,
          .cells = std::move(cells),
          .pixels = std::move(pixels),
          .with_contrast = false};
}

/// Cells are squares: a corner lies beyond the radius that the middles are in.
double reach_rad(double radius_deg, const Cells& cells) {
  return radians(radius_deg + std::numbers::sqrt2 * cells.cell_deg());
}

void keep_only(std::uint32_t cell, CellPixels& pixels) {
  std::erase_if(pixels.members,
                [&](const CellPixels::Member& member) { return member.cell != cell; });
  const std::uint32_t count = pixels.pixels_in_cell[cell];
  std::fill(pixels.pixels_in_cell.begin(), pixels.pixels_in_cell.end(), 0U);
  pixels.pixels_in_cell[cell] = count;
}

}  // namespace

Aim aim_at(const Vec3& object, const DisplaySettings& display) {
  const Viewport viewport(head_orientation(azimuth_elevation(object)),
                          radians(display.horizontal_fov_deg), radians(display.vertical_fov_deg),
                          display.lens);
  return {.viewport = viewport, .gaze = object, .pointer = std::nullopt};
}

double display_pixel_rad(const DisplaySettings& display) {
  const Viewport view(head_orientation({}), radians(display.horizontal_fov_deg),
                      radians(display.vertical_fov_deg), display.lens);
  const Vec2 middle(0.5F);
  const double sr =
      view.sr_per_area(middle) / (static_cast<double>(display.view_width) * display.view_height);
  return std::sqrt(sr);
}

JudgedView view_of_outline(const Vision& vision, const OfferedObject& object, double pixel_rad) {
  auto cells =
      std::make_shared<const Cells>(outline_cells(vision, object.direction, object.radius_deg));
  const double reach = reach_rad(vision.surround_factor * object.radius_deg, *cells);
  JudgedView view = view_around(object.direction, reach, pixel_rad, std::move(cells));
  view.with_contrast = true;
  return view;
}

JudgedView view_of_material(const Vision& vision, const OfferedObject& object, double pixel_rad) {
  auto cells =
      std::make_shared<const Cells>(material_cells(vision, object.direction, object.radius_deg));
  const double reach = reach_rad(object.radius_deg, *cells);
  return view_around(object.direction, reach, pixel_rad, std::move(cells));
}

std::vector<JudgedView> views_around(const Vision& vision, double pixel_rad) {
  const auto cells = std::make_shared<const Cells>(view_cells(vision));
  std::vector<JudgedView> views;
  for (const Cells::Patch& patch : cells->patches()) {
    const double reach = std::numbers::sqrt2 * radians(cells->cell_deg());
    JudgedView view = view_around(patch.direction, reach, pixel_rad, cells);
    keep_only(cells->at(patch.direction), view.pixels);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace foveola::study
