#include "renderer/progressive/exposure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/random.h"

namespace foveola {
namespace {

/// Cells of the small picture, each way, and the samples of each: a fraction of a second of work.
constexpr IVec2 cells{48, 27};
constexpr std::uint32_t samples_per_cell = 16;

/// The seed of its paths and of its samples' places.
constexpr std::uint32_t metering_seed = 0x6d657465U;

std::vector<SampleJob> jobs_through(const Viewport& viewport) {
  std::vector<SampleJob> jobs;
  jobs.reserve(static_cast<std::size_t>(cells.x) * cells.y * samples_per_cell);
  for (int y = 0; y < cells.y; ++y) {
    for (int x = 0; x < cells.x; ++x) {
      const auto cell = static_cast<std::uint32_t>(y * cells.x + x);
      for (std::uint32_t sample = 0; sample < samples_per_cell; ++sample) {
        const Vec2 place = sobol_2d(sample, mix(metering_seed, cell));
        jobs.push_back({.direction = viewport.direction((Vec2(x, y) + place) / Vec2(cells)),
                        .pixel = cell,
                        .sample_number = sample});
      }
    }
  }
  return jobs;
}

/// The mean luminance of each cell, of the samples that are finite.
std::vector<float> means_of_cells(const std::vector<Rgb>& radiance) {
  std::vector<float> means;
  for (std::size_t first = 0; first < radiance.size(); first += samples_per_cell) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + samples_per_cell; ++i) {
      sum += is_finite(radiance[i]) ? luminance(DVec3(radiance[i])) : 0.0;
    }
    means.push_back(static_cast<float>(sum / samples_per_cell));
  }
  return means;
}

}  // namespace

double automatic_exposure_stops(std::vector<float> luminances) {
  constexpr double middle_grey = 0.18;
  constexpr double share_below_bright = 0.95;
  constexpr float darkest_of_bright = 1.0F / 256.0F;
  std::erase_if(luminances, [](float value) { return !(value > 0.0F) || !std::isfinite(value); });
  if (luminances.empty()) {
    return 0.0;
  }
  std::sort(luminances.begin(), luminances.end());
  const auto bright =
      static_cast<std::size_t>(share_below_bright * static_cast<double>(luminances.size() - 1));
  const float darkest = darkest_of_bright * luminances[bright];
  double sum = 0.0;
  std::size_t counted = 0;
  for (const float value : luminances) {
    if (value >= darkest) {
      sum += std::log2(static_cast<double>(value));
      ++counted;
    }
  }
  const double stops = std::log2(middle_grey) - sum / static_cast<double>(counted);
  constexpr double steps_per_stop = 100.0;
  const double rounded = std::round(steps_per_stop * stops) / steps_per_stop;
  return std::clamp(rounded, -most_exposure_stops, most_exposure_stops) + 0.0;  // and never -0
}

double automatic_exposure_stops(const PathTracer& tracer, const Vec3& viewpoint,
                                const Viewport& viewport, TraceSettings trace,
                                const Workers& workers) {
  trace.seed = metering_seed;
  trace.pixel_angle_rad = static_cast<float>(2.0 * viewport.half_size().x / cells.x);
  const std::vector<SampleJob> jobs = jobs_through(viewport);
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, trace, workers);
  return automatic_exposure_stops(means_of_cells(radiance));
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
  const double automatic =
      automatic_exposure_stops(loaded.tracer, loaded.camera.position, viewport, trace, workers);
  return {.stops = automatic + choice.more_stops, .is_automatic = true};
}

std::string exposure_note(const Exposure& exposure) {
  return fmt::format(
      "the exposure was chosen by what is seen, {0:g} stops; --exposure fixed:{0:g} keeps it, and "
      "--exposure +1 or -1 is brighter or darker than that",
      exposure.stops);
}

}  // namespace foveola
