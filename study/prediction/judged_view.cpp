#include "study/prediction/judged_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// A square view around `middle` that reaches radius_rad to all sides; nothing is judged in it yet.
JudgedView view_around(const Vec3& middle, double radius_rad, double pixel_rad) {
  constexpr double widest_rad = 1.4;
  const double half_size = std::tan(std::min(radius_rad, widest_rad));
  const auto side = static_cast<int>(std::ceil(2.0 * half_size / pixel_rad));
  // As many whole pixels as are at least needed, each of the size of the display's.
  const double fov_rad = 2.0 * std::atan(0.5 * side * pixel_rad);
  return {.viewport = Viewport(head_orientation(azimuth_elevation(middle)), fov_rad, fov_rad),
          .width = side,
          .height = side,
          .judged = {}};
}

void judge(Cells cells, bool with_contrast, JudgedView& view) {
  CellPixels pixels = pixels_of(cells, view.viewport, view.width, view.height);
  view.judged.push_back(
      {.cells = std::move(cells), .pixels = std::move(pixels), .with_contrast = with_contrast});
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

}  // namespace

Aim aim_at(const Vec3& object, const DisplaySettings& display) {
  const Viewport viewport(head_orientation(azimuth_elevation(object)),
                          radians(display.horizontal_fov_deg), radians(display.vertical_fov_deg),
                          display.lens);
  return {.viewport = viewport, .gaze = object, .pointer = std::nullopt};
}

JudgedView view_of_object(const Vision& vision, const OfferedObject& object,
                          const DisplaySettings& display) {
  JudgedView view{.viewport = aim_at(object.direction, display).viewport,
                  .width = display.view_width,
                  .height = display.view_height,
                  .judged = {}};
  judge(outline_cells(vision, object.direction, object.radius_deg), true, view);
  for (Cells& cells : material_cells(vision, object.direction, object.radius_deg)) {
    judge(std::move(cells), false, view);
  }
  return view;
}

std::vector<Cells::Patch> surround_patches(const Vision& vision, double highest_deg) {
  std::vector<Cells::Patch> patches = view_cells(vision).back().patches();
  std::erase_if(patches, [&](const Cells::Patch& patch) {
    return std::abs(degrees(azimuth_elevation(patch.direction).elevation_rad)) > highest_deg;
  });
  return patches;
}

std::vector<JudgedView> surround_views(const Vision& vision, const DisplaySettings& display,
                                       const std::vector<Cells::Patch>& patches) {
  const double pixel_rad = display_pixel_rad(display);
  constexpr double smallest_radius_deg = 1.0;
  constexpr double blocks_to_each_side = 0.8;  // a whole block, wherever the grid begins
  const int block = std::max(1, static_cast<int>(std::lround(vision.coarseness)));
  const std::vector<double> scales = scales_deg(vision, vision.view_cell_deg);
  const auto radius_deg = [&](double cell_deg) {
    return std::max(smallest_radius_deg, blocks_to_each_side * block * cell_deg);
  };
  // Cells are squares: a corner lies beyond the radius that the middles are in.
  const double reach_deg = radius_deg(scales.back()) + std::numbers::sqrt2 * scales.back();
  std::vector<JudgedView> views;
  for (const Cells::Patch& patch : patches) {
    views.push_back(view_around(patch.direction, radians(reach_deg), pixel_rad));
    for (const double cell_deg : scales) {
      judge(Cells::around(patch.direction, radius_deg(cell_deg), cell_deg, vision.view_patch_deg,
                          block),
            false, views.back());
    }
  }
  return views;
}

}  // namespace foveola::study
