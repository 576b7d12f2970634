// Measurements of a machine and its devices before a person's session.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gaze/profiles.h"

namespace foveola::study {

/// Frames of one scene and method, shown as in a trial.
struct TrialSpeed {
  std::string scene;
  std::string method;
  std::uint64_t frames = 0;
  std::uint64_t late = 0;  ///< frames that missed their refresh
  double duration_s = 0.0;
  std::uint64_t samples = 0;

  double frame_rate_hz() const { return static_cast<double>(frames) / duration_s; }
  double samples_per_second() const { return static_cast<double>(samples) / duration_s; }
  double late_percent() const {
    return 100.0 * static_cast<double>(late) / static_cast<double>(frames);
  }
};

/// Gaze samples of the eye tracker during the measurement.
struct LiveGaze {
  std::uint64_t samples = 0;
  std::uint64_t valid = 0;
  double duration_s = 0.0;
  std::optional<double> median_age_s;  ///< of the newest valid sample, frame by frame
  std::string status;                  ///< why no samples come, if the tracker knows

  double rate_hz() const {
    return duration_s > 0.0 ? static_cast<double>(samples) / duration_s : 0.0;
  }
  /// Returns the fraction of invalid samples, in [0, 1]; 1 without samples.
  double loss() const {
    return samples > 0 ? 1.0 - static_cast<double>(valid) / static_cast<double>(samples) : 1.0;
  }
};

/// The window's display, as the system describes it.
struct FoundDisplay {
  IVec2 window_px{0};  ///< the window's size
  bool is_full_screen = false;
  IVec2 monitor_px{0};
  double monitor_width_m = 0.0;  ///< 0 if the system does not say
  double refresh_rate_hz = 0.0;
};

struct Preflight {
  std::vector<TrialSpeed> speeds;  ///< of every scene with every method; not empty
  TrackerProfile tracker;
  LiveGaze gaze;
  DisplayProfile display;
  FoundDisplay found_display;
  DVec2 view_deg{0.0};               ///< the window's angles, across and up
  IVec2 film_px{0};                  ///< size of the narrowest 360-degree image of any trial
  std::uint64_t free_bytes = 0;      ///< on the disk of the study's file
  std::optional<bool> is_clock_set;  ///< whether the system synchronises it; empty: unknown
};

/// Describes the differences of the display from its profile; empty if there are none. Angles of a
/// monitor are wrong by as much as its pixels are larger or smaller than stated.
std::vector<std::string> display_differences(const DisplayProfile& stated,
                                             const FoundDisplay& found);

/// Returns whether the profile's display is a headset, but the window is on another display.
bool stands_in_for_headset(const DisplayProfile& stated, const FoundDisplay& found);

/// Returns the source of the gaze: "simulated", "recorded", "pointer" or "tracked".
const char* eye_of(TrackerSource source);

}  // namespace foveola::study
