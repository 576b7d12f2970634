#include "renderer/progressive/render_limits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/scene/prepare/far_geometry.h"

namespace foveola {
namespace {

void require_range(bool is_in_range, const char* name, const std::string& range,
                   const SettingNames& names) {
  if (!is_in_range) {
    throw UsageError(name, "must be " + range, names.remedy);
  }
}

void require_direction(const std::optional<AzimuthElevation>& angles, const char* name,
                       const SettingNames& names) {
  require_range(!angles || (std::isfinite(static_cast<float>(angles->azimuth_rad)) &&
                            std::abs(angles->elevation_rad) <= radians(90.0)),
                name, "a finite azimuth and an elevation from -90 to 90 degrees", names);
}

void require_size(const std::optional<IVec2>& size, const SettingNames& names) {
  constexpr int max_side = 65536;
  require_range(
      !size || (std::min(size->x, size->y) >= 1 && std::max(size->x, size->y) <= max_side),
      names.size, fmt::format("from 1 to {} pixels wide and high", max_side), names);
}

}  // namespace

RenderBudget budget_of(const BudgetChoices& choices, const SettingNames& names) {
  const auto given = {choices.samples_per_pixel.has_value(), choices.samples.has_value(),
                      choices.seconds.has_value()};
  if (std::ranges::count(given, true) > 1) {
    throw UsageError(names.samples_per_pixel,
                     fmt::format("cannot be combined with {} or {}", names.samples, names.seconds),
                     "give one of them");
  }
  const auto require_amount = [&](double amount, double max, const char* name) {
    require_range(amount > 0.0 && amount <= max, name, fmt::format("above 0 and at most {:g}", max),
                  names);
  };
  if (choices.samples) {
    require_amount(static_cast<double>(*choices.samples), 1e15, names.samples);
    return {.samples = static_cast<std::uint64_t>(*choices.samples)};
  }
  if (choices.seconds) {
    require_amount(*choices.seconds, 1e7, names.seconds);
    return {.seconds = *choices.seconds};
  }
  const double samples_per_pixel =
      choices.samples_per_pixel.value_or(choices.default_samples_per_pixel);
  require_amount(samples_per_pixel, 1e7, names.samples_per_pixel);
  return {.samples_per_pixel = samples_per_pixel};
}

void require_possible(const RenderSettings& settings, const SettingNames& names) {
  constexpr int max_threads = 1024;
  if (const std::optional<DVec3>& camera = settings.scene.camera) {
    require_range(
        std::abs(camera->x) <= max_coordinate_m && std::abs(camera->y) <= max_coordinate_m &&
            std::abs(camera->z) <= max_coordinate_m,
        names.camera, fmt::format("three numbers of at most {:g}", max_coordinate_m), names);
  }
  require_direction(settings.scene.head, names.head, names);
  require_direction(settings.gaze, names.gaze, names);
  require_size(settings.progressive.film_size, names);
  require_size(settings.picture ? settings.picture->size : std::nullopt, names);
  require_range(settings.progressive.trace.max_depth >= 1, names.max_depth, "at least 1", names);
  require_range(settings.threads >= 0 && settings.threads <= max_threads, names.threads,
                fmt::format("from 0 (every core) to {}", max_threads), names);
}

}  // namespace foveola
