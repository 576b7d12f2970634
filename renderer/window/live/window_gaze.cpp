#include "renderer/window/live/window_gaze.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace foveola {
namespace {

constexpr int dots = 5;

}  // namespace

void TrackerCheck::begin(const ViewGeometry& geometry, const CalibrationTiming& timing,
                         Nanoseconds now) {
  routine_.emplace(
      calibration_targets(dots, geometry.horizontal_fov_deg, geometry.vertical_fov_deg), timing,
      now);
}

std::optional<std::vector<WatchedTarget>> TrackerCheck::update(
    Nanoseconds now, std::span<const GazeSample> arrived) {
  if (!routine_) {
    return std::nullopt;
  }
  routine_->update(now, arrived);
  if (routine_->target()) {
    return std::nullopt;
  }
  std::optional watched(routine_->watched());
  end();
  return watched;
}

ViewOverlays TrackerCheck::overlays(const Quat& head) const {
  constexpr float easily_seen_px = 10.0F;
  return {.target = head * *routine_->target(), .min_target_px = easily_seen_px};
}

TextPanel TrackerCheck::panel() const {
  return {.place = PanelPlace::upper,
          .lines = {fmt::format("Look at the dot: {} of {}", routine_->watched().size() + 1, dots),
                    "Escape ends the check"}};
}

void WidenedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const auto before = static_cast<std::ptrdiff_t>(arrived.size());
  source_->poll(now, arrived);
  if (factor_ == 1.0) {
    return;
  }
  std::for_each(arrived.begin() + before, arrived.end(), [this](GazeSample& sample) {
    // Directions behind are on no screen.
    if (sample.valid && sample.direction.z < 0.0F) {
      const DVec3 seen(sample.direction);
      sample.direction = Vec3(glm::normalize(DVec3(factor_ * seen.x, factor_ * seen.y, seen.z)));
    }
  });
}

PlacedEyeTracker::PlacedEyeTracker(std::unique_ptr<EyeTracker> source,
                                   const DisplayProfile& display,
                                   std::function<std::optional<WindowPlace>()> place)
    : source_(std::move(source)),
      display_px_(display.width_px, display.height_px),
      pixel_(DVec2(display.width_m, display.height_m) / display_px_ / display.viewing_distance_m),
      place_(std::move(place)) {}

void PlacedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const auto before = static_cast<std::ptrdiff_t>(arrived.size());
  source_->poll(now, arrived);
  const std::optional<WindowPlace> place = place_();
  std::for_each(arrived.begin() + before, arrived.end(), [&](GazeSample& sample) {
    if (!place || !sample.valid || sample.direction.z >= 0.0F) {
      sample.valid = false;
      return;
    }
    const DVec3 told(sample.direction);
    const DVec2 on_monitor =
        DVec2(told.x, told.y) / -told.z * DVec2(place->monitor_px) / display_px_;
    const DVec2 middle = DVec2(place->centre_px.x, -place->centre_px.y) * pixel_;
    sample.direction = Vec3(glm::normalize(DVec3(on_monitor - middle, -1.0)));
  });
}

std::string PlacedEyeTracker::status() const {
  return place_() ? source_->status()
                  : "the window fills none of the monitors, one of which the tracker watches";
}

}  // namespace foveola
