#include "renderer/progressive/exposure.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "renderer/progressive/small_picture.h"

namespace foveola {
namespace {

/// A fraction of a second of work.
constexpr IVec2 metered_pixels{48, 27};

/// The seed of the paths that are metered.
constexpr std::uint32_t metering_seed = 0x6d657465U;

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
  std::vector<float> luminances;
  for (const DVec3& radiance : small_picture(tracer, viewpoint, viewport,
                                             {.size = metered_pixels, .trace = trace}, workers)) {
    luminances.push_back(static_cast<float>(luminance(radiance)));
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
