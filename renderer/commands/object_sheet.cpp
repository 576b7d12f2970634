#include "renderer/commands/object_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/progress.h"
#include "renderer/base/random.h"
#include "renderer/commands/drawn_text.h"
#include "renderer/view/viewport.h"

namespace foveola {
namespace {

constexpr int columns = 4;
constexpr int side_px = 192;
constexpr int gap_px = 8;
constexpr int label_px = 20;
constexpr int samples_per_pixel = 16;

Viewport view_of(const LoadedScene& loaded, const ObjectOfInterest& object) {
  const Vec3 towards = loaded.scene.from_file(DVec3(object.position)) - loaded.camera.position;
  const double fov_deg = std::clamp(4.0 * object.radius_deg, 4.0, 120.0);
  return {azimuth_elevation(towards), {.horizontal_deg = fov_deg, .vertical_deg = fov_deg}};
}

/// The samples of a square picture, pixel after pixel.
std::vector<SampleJob> jobs_of(const Viewport& view) {
  std::vector<SampleJob> jobs;
  for (std::uint32_t pixel = 0; pixel < side_px * side_px; ++pixel) {
    const Vec2 corner(pixel % side_px, pixel / side_px);
    for (std::uint32_t sample = 0; sample < samples_per_pixel; ++sample) {
      const Vec2 plane = (corner + sobol_2d(sample, mix(pixel))) / static_cast<float>(side_px);
      jobs.push_back({.direction = view.direction(plane), .pixel = pixel, .sample_number = sample});
    }
  }
  return jobs;
}

/// What is brighter than white by this factor is cut: few samples leave bright specks otherwise.
constexpr double largest_white = 4.0;

RgbImage picture_of(const LoadedScene& loaded, const Viewport& view, double exposure_stops,
                    const Workers& workers) {
  const std::vector<SampleJob> jobs = jobs_of(view);
  std::vector<Rgb> radiance(jobs.size());
  const TraceSettings settings{
      .pixel_angle_rad = 2.0F * view.half_size().x / side_px,
      .largest_radiance = static_cast<float>(largest_white * std::exp2(-exposure_stops))};
  loaded.tracer.trace(loaded.camera.position, jobs, radiance, settings, workers);
  RgbImage picture(side_px, side_px);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (is_finite(radiance[i])) {
      picture.pixels[jobs[i].pixel] += radiance[i] / static_cast<float>(samples_per_pixel);
    }
  }
  return picture;
}

void paste_exposed(const RgbImage& from, const IVec2& corner, double stops, RgbImage& to) {
  const auto factor = static_cast<float>(std::exp2(stops));
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      to.at(corner.x + x, corner.y + y) = factor * from.at(x, y);
    }
  }
}

IVec2 corner_of(std::size_t object) {
  const IVec2 place(static_cast<int>(object) % columns, static_cast<int>(object) / columns);
  return {gap_px + place.x * (side_px + gap_px), gap_px + place.y * (side_px + label_px + gap_px)};
}

}  // namespace

RgbImage object_sheet(const LoadedScene& loaded, const SceneSource& source, double exposure_stops,
                      const Workers& workers, const std::stop_token& stop) {
  const std::size_t count = source.objects.size();
  const IVec2 last = corner_of(count - 1);
  const int right = count < columns ? last.x : corner_of(columns - 1).x;
  RgbImage sheet(right + side_px + gap_px, last.y + side_px + label_px + gap_px);
  const TextDrawing labels;
  Progress progress("drawing the objects");
  for (std::size_t i = 0; i < count; ++i) {
    const IVec2 corner = corner_of(i);
    const Viewport view = view_of(loaded, source.objects[i]);
    paste_exposed(picture_of(loaded, view, exposure_stops, workers), corner, exposure_stops, sheet);
    labels.draw(fmt::format("{}  {}", i + 1, source.objects[i].name),
                corner + IVec2(0, side_px + gap_px / 2), side_px, sheet);
    progress.update(static_cast<double>(i + 1) / static_cast<double>(count));
    if (stop.stop_requested()) {
      throw Error("scene describe", "was stopped before the objects were drawn");
    }
  }
  return sheet;
}

}  // namespace foveola
