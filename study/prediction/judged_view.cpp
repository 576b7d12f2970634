#include "study/prediction/judged_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// Returns a square view around `middle` that extends by radius_rad to all sides, without judged
/// cells.
JudgedView view_around(const Vec3& middle, double radius_rad, double pixel_rad) {
  constexpr double widest_rad = 1.4;
  const double half_size = std::tan(std::min(radius_rad, widest_rad));
  const auto side = static_cast<int>(std::ceil(2.0 * half_size / pixel_rad));
  // The minimum number of whole pixels, each of the display's size.
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

double display_pixel_rad(const DisplaySettings& display) {
  const Viewport view(head_orientation({}), radians(display.horizontal_fov_deg),
                      radians(display.vertical_fov_deg), display.lens);
  const Vec2 middle(0.5F);
  const double sr =
      view.sr_per_area(middle) / (static_cast<double>(display.view_width) * display.view_height);
  return std::sqrt(sr);
}

}  // namespace

std::string crop_sampler(const Cone& cone) {
  const AzimuthElevation middle = azimuth_elevation(cone.middle);
  const double ratio = std::sin(cone.radius_rad) / std::cos(middle.elevation_rad);
  const bool holds_pole =
      std::abs(middle.elevation_rad) + cone.radius_rad >= 0.5 * std::numbers::pi;
  const double half_width_rad = holds_pole ? std::numbers::pi : std::asin(std::min(1.0, ratio));
  return fmt::format("crop:azimuth={},elevation={},width={},height={}", degrees(middle.azimuth_rad),
                     degrees(middle.elevation_rad), 2.0 * degrees(half_width_rad),
                     2.0 * degrees(cone.radius_rad));
}

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

std::vector<Vec3> surround_places(const Vision& vision, double highest_deg) {
  const auto parts_of = [](double whole_deg, double part_deg) {
    return std::max(1, static_cast<int>(std::lround(whole_deg / part_deg)));
  };
  const int rows = parts_of(180.0, vision.view_patch_deg);
  const double height_deg = 180.0 / rows;
  std::vector<Vec3> places;
  for (int row = 0; row < rows; ++row) {
    const double elevation_deg = -90.0 + (row + 0.5) * height_deg;
    if (std::abs(elevation_deg) > highest_deg) {
      continue;
    }
    const int columns = parts_of(360.0 * std::cos(radians(elevation_deg)), height_deg);
    for (int column = 0; column < columns; ++column) {
      const double azimuth_deg = -180.0 + 360.0 * (column + 0.5) / columns;
      places.push_back(direction_from(
          {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)}));
    }
  }
  return places;
}

std::vector<JudgedView> surround_views(const Vision& vision, const DisplaySettings& display,
                                       const std::vector<Vec3>& places) {
  constexpr double radius_deg = 1.0;
  const double pixel_rad = display_pixel_rad(display);
  std::vector<JudgedView> views;
  for (const Vec3& place : places) {
    std::vector<Cells> of_scales;
    double half_width_rad = 0.0;
    for (const double cell_deg : scales_deg(vision, vision.view_cell_deg)) {
      of_scales.push_back(cells_around(vision, place, radius_deg, cell_deg));
      half_width_rad = std::max(half_width_rad, of_scales.back().half_width_rad());
    }
    views.push_back(view_around(place, half_width_rad, pixel_rad));
    for (Cells& cells : of_scales) {
      judge(std::move(cells), false, views.back());
    }
  }
  return views;
}

}  // namespace foveola::study
