#include "renderer/progressive/exposure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/numbers/random.h"

namespace foveola {
namespace {

/// Jobs pixel by pixel.
std::vector<SampleJob> jobs_through(const Viewport& viewport,
                                    const SmallPictureSettings& settings) {
  const IVec2& size = settings.size;
  std::vector<SampleJob> jobs;
  jobs.reserve(static_cast<std::size_t>(size.x) * size.y * settings.samples_per_pixel);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * size.x + x);
      for (std::uint32_t sample = 0; sample < settings.samples_per_pixel; ++sample) {
        const Vec2 place = sobol_2d(sample, mix(settings.trace.seed, pixel));
        jobs.push_back({.direction = viewport.direction((Vec2(x, y) + place) / Vec2(size)),
                        .pixel = pixel,
                        .sample_number = sample});
      }
    }
  }
  return jobs;
}

/// A fraction of a second of work.
constexpr IVec2 metered_pixels{48, 27};

/// The seed of the metering paths.
constexpr std::uint32_t metering_seed = 0x6d657465U;

/// Marks the metered pixels that show only the scene and no environment, by rays through the
/// corners of each; all, if these are too few to be the picture's subject.
std::vector<bool> metered(const RayScene& rays, const Vec3& viewpoint, const Viewport& viewport) {
  constexpr double least_share = 0.05;
  const IVec2 corners = metered_pixels + 1;
  std::vector<bool> meets;
  for (int y = 0; y < corners.y; ++y) {
    for (int x = 0; x < corners.x; ++x) {
      const Vec3 direction = viewport.direction(Vec2(x, y) / Vec2(metered_pixels));
      meets.push_back(!rays.closest_hit(viewpoint, direction).missed());
    }
  }
  std::vector<bool> shows_scene;
  for (int y = 0; y < metered_pixels.y; ++y) {
    for (int x = 0; x < metered_pixels.x; ++x) {
      const auto corner = static_cast<std::size_t>(y * corners.x + x);
      shows_scene.push_back(meets[corner] && meets[corner + 1] && meets[corner + corners.x] &&
                            meets[corner + corners.x + 1]);
    }
  }
  const auto pixels = static_cast<double>(shows_scene.size());
  const auto count = std::ranges::count(shows_scene, true);
  return static_cast<double>(count) >= least_share * pixels
             ? shows_scene
             : std::vector<bool>(shows_scene.size(), true);
}

}  // namespace

std::vector<DVec3> small_picture(const PathTracer& tracer, const Vec3& viewpoint,
                                 const Viewport& viewport, SmallPictureSettings settings,
                                 const Workers& workers) {
  settings.trace.pixel_angle_rad =
      static_cast<float>(2.0 * viewport.half_size().x / settings.size.x);
  const std::vector<SampleJob> jobs = jobs_through(viewport, settings);
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, settings.trace, workers);
  std::vector<DVec3> means(static_cast<std::size_t>(settings.size.x) * settings.size.y);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (is_finite(radiance[i])) {
      means[jobs[i].pixel] += DVec3(radiance[i]);
    }
  }
  for (DVec3& mean : means) {
    mean /= settings.samples_per_pixel;
  }
  return means;
}

std::optional<double> automatic_exposure_stops(std::vector<float> luminances) {
  constexpr double middle_grey = 0.18;
  constexpr double share_below_bright = 0.95;
  constexpr float darkest_of_bright = 1.0F / 256.0F;
  constexpr double max_for_bright = 2.0;
  std::erase_if(luminances, [](float value) { return !(value > 0.0F) || !std::isfinite(value); });
  if (luminances.empty()) {
    return std::nullopt;
  }
  std::ranges::sort(luminances);
  const float bright = luminances[static_cast<std::size_t>(
      share_below_bright * static_cast<double>(luminances.size() - 1))];
  const float darkest = darkest_of_bright * bright;
  double sum = 0.0;
  std::size_t counted = 0;
  for (const float value : luminances) {
    if (value >= darkest) {
      sum += std::log2(static_cast<double>(value));
      ++counted;
    }
  }
  const double by_mean = std::log2(middle_grey) - sum / static_cast<double>(counted);
  const double bright_is_white = -std::log2(static_cast<double>(bright));
  const double stops = std::max(std::min(by_mean, bright_is_white), by_mean - max_for_bright);
  constexpr double steps_per_stop = 100.0;
  const double rounded = std::round(steps_per_stop * stops) / steps_per_stop;
  return std::clamp(rounded, -max_exposure_stops, max_exposure_stops) + 0.0;  // and never -0
}

std::optional<double> automatic_exposure_stops(const PathTracer& tracer, const Vec3& viewpoint,
                                               const Viewport& viewport, TraceSettings trace,
                                               const Workers& workers) {
  trace.seed = metering_seed;
  const std::vector<DVec3> radiances =
      small_picture(tracer, viewpoint, viewport, {.size = metered_pixels, .trace = trace}, workers);
  const std::vector<bool> is_metered = metered(tracer.ray_scene(), viewpoint, viewport);
  std::vector<float> luminances;
  for (std::size_t i = 0; i < radiances.size(); ++i) {
    if (is_metered[i]) {
      luminances.push_back(static_cast<float>(luminance(radiances[i])));
    }
  }
  return automatic_exposure_stops(std::move(luminances));
}

Exposure chosen_exposure(const ExposureChoice& choice, const LoadedScene& loaded,
                         const Viewport& viewport, const TraceSettings& trace,
                         const Workers& workers) {
  const std::optional<double>& own = loaded.source.exposure_stops;
  if (choice.base == ExposureChoice::Base::none) {
    return {.stops = choice.more_stops};
  }
  if (choice.base == ExposureChoice::Base::scene && own) {
    return {.stops = *own + choice.more_stops};
  }
  const std::optional<double> automatic =
      automatic_exposure_stops(loaded.tracer, loaded.camera.position, viewport, trace, workers);
  return {.stops = automatic.value_or(0.0) + choice.more_stops,
          .is_automatic = automatic.has_value()};
}

std::string exposure_note(const Exposure& exposure) {
  return fmt::format(
      "the exposure is automatic, {0:g} stops; --exposure fixed:{0:g} keeps it, and --exposure +1 "
      "or -1 is brighter or darker than that",
      exposure.stops);
}

}  // namespace foveola
