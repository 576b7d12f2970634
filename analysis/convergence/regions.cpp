#include "analysis/convergence/regions.h"

#include <array>

#include <fmt/format.h>

#include "renderer/view/acuity.h"
#include "renderer/view/equirect.h"

namespace foveola::analysis {
namespace {

constexpr std::array disc_radii_deg = {2, 5, 10, 20};

Region disc(const Vec3& gaze, int radius_deg) {
  return {.name = fmt::format("{}deg", radius_deg),
          .weight =
              [gaze, radius_rad = radians(radius_deg)](const Vec3& direction) {
                return angle_between(gaze, direction) <= radius_rad ? 1.0 : 0.0;
              },
          .is_in_view = true};
}

void add_pixel(std::uint32_t index, double weight, PixelRegion& region) {
  if (weight > 0.0) {
    region.pixels.push_back({.index = index, .weight = static_cast<float>(weight)});
  }
}

}  // namespace

std::vector<Region> regions_around(const Vec3& gaze, const Viewport& viewport) {
  std::vector<Region> regions;
  for (const int radius_deg : disc_radii_deg) {
    regions.push_back(disc(gaze, radius_deg));
  }
  regions.push_back(
      {.name = "viewport",
       .weight = [viewport](const Vec3& d) { return viewport.project(d) ? 1.0 : 0.0; },
       .is_in_view = true});
  regions.push_back({.name = "acuity",
                     .weight =
                         [viewport, gaze](const Vec3& d) {
                           return viewport.project(d)
                                      ? reddy_acuity(degrees(angle_between(gaze, d)))
                                      : 0.0;
                         },
                     .is_in_view = true});
  regions.push_back({.name = "sphere", .weight = [](const Vec3&) { return 1.0; }});
  return regions;
}

PixelRegion region_on_film(const Region& region, const IVec2& size) {
  PixelRegion pixels;
  std::uint32_t index = 0;
  for (int y = 0; y < size.y; ++y) {
    const double v = (y + 0.5) / size.y;
    const double cosine = std::sin(std::numbers::pi * v);  // of the latitude
    for (int x = 0; x < size.x; ++x, ++index) {
      const Vec3 middle = direction_from_equirect(Vec2((x + 0.5) / size.x, v));
      add_pixel(index, cosine * region.weight(middle), pixels);
    }
  }
  return pixels;
}

PixelRegion region_on_view(const Region& region, const Viewport& viewport, int size) {
  PixelRegion pixels;
  std::uint32_t index = 0;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x, ++index) {
      const Vec2 middle = (Vec2(x, y) + 0.5F) / static_cast<float>(size);
      add_pixel(index, viewport.sr_per_area(middle) * region.weight(viewport.direction(middle)),
                pixels);
    }
  }
  return pixels;
}

}  // namespace foveola::analysis
