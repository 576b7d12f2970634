#include "study/preflight/preflight.h"

#include <cmath>

#include <fmt/format.h>

namespace foveola::study {
namespace {

// Relative tolerance of sizes: monitors report rounded ones, and people measure with a ruler.
constexpr double size_tolerance = 0.05;
constexpr double rate_tolerance = 0.05;

bool differs(double found, double stated, double tolerance) {
  return std::abs(found - stated) > tolerance * stated;
}

void compare_pixels(const DisplayProfile& stated, const FoundDisplay& found,
                    std::vector<std::string>& differences) {
  const IVec2 stated_px(stated.width_px, stated.height_px);
  if (stated.kind == DisplayKind::openxr) {
    return;  // its runtime's values are the stated ones
  }
  const IVec2& shown_px = stated.kind == DisplayKind::headset ? found.window_px : found.monitor_px;
  if (shown_px != stated_px) {
    differences.push_back(
        fmt::format("{} {}x{} pixels, not {}x{}",
                    stated.kind == DisplayKind::headset ? "the window has" : "the monitor has",
                    shown_px.x, shown_px.y, stated_px.x, stated_px.y));
  }
}

void compare_pixel_sizes(const DisplayProfile& stated, const FoundDisplay& found,
                         std::vector<std::string>& differences) {
  if (stated.kind != DisplayKind::monitor || found.monitor_width_m <= 0.0) {
    return;
  }
  constexpr double mm_per_m = 1e3;
  const double stated_mm = mm_per_m * stated.width_m / stated.width_px;
  const double found_mm = mm_per_m * found.monitor_width_m / found.monitor_px.x;
  if (differs(found_mm, stated_mm, size_tolerance)) {
    differences.push_back(
        fmt::format("its pixels are {:.3f} mm wide, not {:.3f}: angles are wrong by {:.0f} %",
                    found_mm, stated_mm, 100.0 * (found_mm / stated_mm - 1.0)));
  }
}

}  // namespace

std::vector<std::string> display_differences(const DisplayProfile& stated,
                                             const FoundDisplay& found) {
  std::vector<std::string> differences;
  compare_pixels(stated, found, differences);
  compare_pixel_sizes(stated, found, differences);
  if (differs(found.refresh_rate_hz, stated.refresh_rate_hz, rate_tolerance)) {
    differences.push_back(fmt::format("it refreshes at {:.1f} Hz, not {:.1f}",
                                      found.refresh_rate_hz, stated.refresh_rate_hz));
  }
  return differences;
}

bool stands_in_for_headset(const DisplayProfile& stated, const FoundDisplay& found) {
  return stated.kind == DisplayKind::headset &&
         !(found.is_full_screen && found.window_px == IVec2(stated.width_px, stated.height_px));
}

const char* eye_of(TrackerSource source) {
  switch (source) {
    case TrackerSource::simulated:
      return "simulated";
    case TrackerSource::recorded:
      return "recorded";
    case TrackerSource::pointer:
      return "pointer";
    case TrackerSource::hid:
    case TrackerSource::open_gaze:
    case TrackerSource::openxr:
      break;
  }
  return "tracked";
}

}  // namespace foveola::study
