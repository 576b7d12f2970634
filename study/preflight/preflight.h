// What is measured of a machine and its devices before a person's session begins.
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
  std::uint64_t late = 0;  ///< missed their refresh
  double duration_s = 0.0;
  std::uint64_t samples = 0;

  double frame_rate_hz() const { return static_cast<double>(frames) / duration_s; }
  double samples_per_second() const { return static_cast<double>(samples) / duration_s; }
  double late_percent() const {
    return 100.0 * static_cast<double>(late) / static_cast<double>(frames);
  }
};

/// What came from the eye tracker meanwhile.
struct LiveGaze {
  std::uint64_t samples = 0;
  std::uint64_t valid = 0;
  double duration_s = 0.0;
  std::optional<double> median_age_s;  ///< of the newest valid sample, frame by frame
  std::string status;                  ///< why none come, if the tracker knows

  double rate_hz() const {
    return duration_s > 0.0 ? static_cast<double>(samples) / duration_s : 0.0;
  }
  /// The part that is not valid, in [0, 1]; 1 if none came.
  double loss() const {
    return samples > 0 ? 1.0 - static_cast<double>(valid) / static_cast<double>(samples) : 1.0;
  }
};

/// The display that the window is on, as the system describes it.
struct FoundDisplay {
  IVec2 window_px{0};  ///< the window's size
  bool is_full_screen = false;
  IVec2 monitor_px{0};
  double monitor_width_m = 0.0;  ///< 0 if the system does not say
  double refresh_rate_hz = 0.0;
};

struct Preflight {
  std::vector<TrialSpeed> speeds;  ///< at least one, of every scene with every method
  TrackerProfile tracker;
  LiveGaze gaze;
  DisplayProfile display;
  FoundDisplay found_display;
  DVec2 view_deg{0.0};               ///< the angles that the window shows, across and up
  IVec2 film_px{0};                  ///< the 360-degree image's size, the narrowest of all trials'
  std::uint64_t free_bytes = 0;      ///< on the disk of the study's file
  std::optional<bool> is_clock_set;  ///< whether the system synchronises it; empty: it does not say
};

/// How the display differs from what its profile states, in words; empty if it does not. Angles of
/// a monitor are wrong by as much as its pixels are larger or smaller than stated.
std::vector<std::string> display_differences(const DisplayProfile& stated,
                                             const FoundDisplay& found);

/// Whether the profile's display is a headset, while the window is on something else.
bool stands_in_for_headset(const DisplayProfile& stated, const FoundDisplay& found);

/// Whose eye it is: "simulated", "recorded", "pointer" or "tracked".
const char* eye_of(TrackerSource source);

}  // namespace foveola::study
