#include "renderer/gaze/eye_tracker.h"

#include <cmath>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"

namespace foveola {
namespace {

/// Turns `direction` by two independent normal angles, across and up.
Vec3 with_noise(const Vec3& direction, double precision_deg, Pcg32& noise) {
  const Frame frame(direction);
  const double across = std::tan(radians(precision_deg * noise.normal()));
  const double up = std::tan(radians(precision_deg * noise.normal()));
  return glm::normalize(direction + static_cast<float>(across) * frame.tangent +
                        static_cast<float>(up) * frame.bitangent);
}

}  // namespace

std::optional<GazeSample> FixedEyeTracker::newest(Nanoseconds now) {
  return GazeSample{.time = now, .direction = direction_, .valid = true};
}

SimulatedEyeTracker::SimulatedEyeTracker(const SimulatedTrackerSettings& settings,
                                         TrueGaze true_gaze)
    : settings_(settings), true_gaze_(std::move(true_gaze)) {}

std::optional<GazeSample> SimulatedEyeTracker::newest(Nanoseconds now) {
  const double newest_exposure_s = seconds(now) - settings_.latency_s;
  const auto newest_index =
      static_cast<std::int64_t>(std::floor(newest_exposure_s * settings_.rate_hz));
  if (newest_index < 0 || newest_index == newest_index_) {
    return newest_;
  }
  newest_index_ = newest_index;
  newest_ = expose(newest_index);
  return newest_;
}

GazeSample SimulatedEyeTracker::expose(std::int64_t index) const {
  const Nanoseconds time = nanoseconds_from_seconds(static_cast<double>(index) / settings_.rate_hz);
  const std::optional<Vec3> eye = true_gaze_(time);
  if (!eye) {
    return {.time = time};
  }
  // Keyed by the sample's index: what the host polls does not change what the tracker saw.
  Pcg32 noise(mix(settings_.seed, static_cast<std::uint32_t>(index)));
  return {
      .time = time, .direction = with_noise(*eye, settings_.precision_deg, noise), .valid = true};
}

}  // namespace foveola
