#include "analysis/convergence/scorer.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/transformed.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/measure/flip.h"
#include "renderer/measure/reference.h"
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

Scorer::Scorer(const ConvergencePlan& plan, const Viewport& viewport, double exposure_stops,
               const std::vector<Region>& regions, ReferenceHalves reference,
               const Workers& workers)
    : viewport_(viewport),
      exposure_stops_(exposure_stops),
      view_size_(plan.view_size),
      regions_(&regions),
      reference_(std::move(reference)),
      workers_(&workers) {
  for (const Region& region : regions) {
    film_regions_.push_back(region_on_film(region, plan.size));
    view_regions_.push_back(region_on_view(region, viewport, view_size_));
  }
  reference_view_ = shown(viewport_image(this->reference(), viewport_, view_size_, view_size_));
}

std::vector<Score> Scorer::score(const EquirectFilm& film) const {
  const FilmImage image = film.resolve();
  const RgbImage view = shown(
      viewport_image(film, viewport_, view_size_, view_size_, UnsampledPixels::black, *workers_));
  const double fov_rad = 2.0 * std::atan(static_cast<double>(viewport_.half_size().x));
  const std::vector<float> flip =
      flip_errors(view, reference_view_, pixels_per_degree(fov_rad, view_size_));
  std::vector<Score> scores;
  for (std::size_t i = 0; i < regions_->size(); ++i) {
    Score score{.error = region_error(image, reference_, film_regions_[i])};
    if ((*regions_)[i].is_in_view) {
      score.flip = region_mean(flip, view_regions_[i]);
    }
    scores.push_back(score);
  }
  return scores;
}

RgbImage Scorer::reference() const {
  RgbImage mean = reference_.first;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    mean.pixels[i] = 0.5F * (mean.pixels[i] + reference_.second.pixels[i]);
  }
  return mean;
}

RgbImage Scorer::shown(const RgbImage& view) const { return display_image(view, exposure_stops_); }

RgbImage reference_half(const Subject& subject, const ConvergencePlan& plan, const Vec3& gaze,
                        std::uint32_t half, const Workers& workers,
                        const std::filesystem::path& cache,
                        const std::function<void(double)>& progress, const std::stop_token& stop) {
  ReferenceSettings settings;
  settings.viewpoint = subject.loaded.camera.position;
  settings.width = plan.size.x;
  settings.height = plan.size.y;
  settings.max_depth = plan.max_depth;
  settings.seed = half;
  settings.samples_per_pixel = plan.reference_samples_per_pixel;
  settings.interests = {gaze};
  settings.samples_per_interest = static_cast<std::uint64_t>(plan.reference_foveated_per_pixel) *
                                  static_cast<std::uint64_t>(plan.size.x) *
                                  static_cast<std::uint64_t>(plan.size.y);
  return reference_image(subject.loaded.tracer, subject.key, settings, workers, cache, progress,
                         stop)
      .color;
}

ReferenceHalves reference_halves(const Subject& subject, const ConvergencePlan& plan,
                                 const Vec3& gaze, const Workers& workers,
                                 const std::filesystem::path& cache,
                                 const std::function<void(double)>& progress,
                                 const std::stop_token& stop) {
  const auto half = [&](std::uint32_t number) {
    const auto so_far = [&](double fraction) { progress(0.5 * (number + fraction)); };
    return reference_half(subject, plan, gaze, number, workers, cache, so_far, stop);
  };
  RgbImage first = half(0);
  return {.first = std::move(first), .second = half(1)};
}

std::vector<Region> regions_around(const Vec3& gaze, const Viewport& viewport) {
  std::vector<Region> regions =
      transformed(disc_radii_deg, [&](const int radius_deg) { return disc(gaze, radius_deg); });
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
