#include "renderer/commands/bench_density.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/print.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

constexpr int width = 2048;
constexpr int height = 1024;
constexpr std::uint64_t samples_in_all = std::uint64_t{1} << 23;
constexpr std::array ring_ends_deg = {0.5,  1.0,  2.0,  3.0,  4.0,   5.0,   5.79, 7.5,
                                      10.0, 12.5, 15.0, 20.0, 25.0,  30.0,  40.0, 50.0,
                                      60.0, 70.0, 80.0, 90.0, 120.0, 150.0, 180.0};

/// The pixels whose middles lie in a ring.
struct Ring {
  double end_deg = 0.0;
  double square_degrees = 0.0;
  double counted = 0.0;
  double stated = 0.0;  ///< samples expected by the method's stated density
};

/// Midpoints along a side of a pixel by which a density is integrated: many where it is steep.
int midpoints(double eccentricity_deg) {
  return eccentricity_deg < 3.0 ? 16 : eccentricity_deg < 10.0 ? 4 : 2;
}

/// The solid angle of a pixel, and the integral of the stated density over it.
struct PixelIntegral {
  double sr = 0.0;
  double stated = 0.0;
};

PixelIntegral integrate(const ViewSampler& sampler, int x, int y, int n) {
  PixelIntegral sum;
  const double cell = 2.0 * std::numbers::pi * std::numbers::pi / width / height / (n * n);
  for (int i = 0; i < n * n; ++i) {
    const double u = (x + (i % n + 0.5) / n) / width;
    const double v = (y + (i / n + 0.5) / n) / height;
    const double sr = cell * std::sin(std::numbers::pi * v);
    sum.sr += sr;
    sum.stated += sr * sampler.density_per_sr(direction_from_equirect(Vec2(u, v)));
  }
  return sum;
}

std::vector<Ring> measure(const ViewSampler& sampler, const Vec3& gaze) {
  constexpr std::uint64_t per_pass = std::uint64_t{1} << 20;
  const Workers workers;
  const Scene nothing;  // where samples fall depends on no scene, and none is traced
  const PathTracer tracer(nothing, workers);
  ProgressiveRender render(tracer, {.film_size = {width, height}}, workers);
  render.begin_pattern(1);
  while (render.points_drawn() < samples_in_all) {
    render.pass_over(sampler, per_pass);
  }
  std::vector<Ring> rings;
  for (const double end_deg : ring_ends_deg) {
    rings.push_back({.end_deg = end_deg});
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 middle = direction_from_equirect(Vec2((x + 0.5) / width, (y + 0.5) / height));
      const double e = degrees(angle_between(middle, gaze));
      const auto found = std::lower_bound(ring_ends_deg.begin(), ring_ends_deg.end() - 1, e);
      Ring& ring = rings[static_cast<std::size_t>(found - ring_ends_deg.begin())];
      const PixelIntegral pixel = integrate(sampler, x, y, midpoints(e));
      ring.square_degrees += pixel.sr * degrees(1.0) * degrees(1.0);
      ring.stated += pixel.stated * static_cast<double>(samples_in_all);
      ring.counted += render.film().sample_count(x, y);
    }
  }
  return rings;
}

}  // namespace

void print_density(const std::string& method, bool as_json) {
  const Vec3 gaze = direction_from({.azimuth_rad = 0.2, .elevation_rad = -0.1});
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport({}, FieldOfView{}), .gaze = gaze});
  nlohmann::json list = nlohmann::json::array();
  if (!as_json) {
    print_text("{}: {} samples on a film of {}x{}\n", method, samples_in_all, width, height);
    print_text("{:>16} {:>12} {:>16} {:>16} {:>8}\n", "degrees from", "samples", "a square degree",
               "stated", "ratio");
  }
  double begin_deg = 0.0;
  for (const Ring& ring : measure(*sampler, gaze)) {
    const double counted = ring.counted / ring.square_degrees;
    const double stated = ring.stated / ring.square_degrees;
    if (as_json) {
      list.push_back({{"from_deg", begin_deg},
                      {"to_deg", ring.end_deg},
                      {"samples", ring.counted},
                      {"samples_per_square_degree", counted},
                      {"stated_per_square_degree", stated}});
    } else {
      print_text("{:>7.2f}..{:<7.2f} {:>12.0f} {:>16.2f} {:>16.2f} {:>8}\n", begin_deg,
                 ring.end_deg, ring.counted, counted, stated,
                 stated > 0.0 ? fmt::format("{:.4f}", counted / stated) : "");
    }
    begin_deg = ring.end_deg;
  }
  if (as_json) {
    print_text("{}\n", nlohmann::json{{"method", method}, {"rings", list}}.dump(2));
  }
}

}  // namespace foveola
