#include "renderer/window/tracker_check.h"

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
  return {.target = head * *routine_->target(), .least_target_px = easily_seen_px};
}

TextPanel TrackerCheck::panel() const {
  return {.place = PanelPlace::upper,
          .lines = {fmt::format("Look at the dot: {} of {}", routine_->watched().size() + 1, dots),
                    "Escape ends the check"}};
}

}  // namespace foveola
