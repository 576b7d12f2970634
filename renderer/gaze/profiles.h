// What is known of displays and trackers: TOML files, chosen by name.
//
// A profile is named by the file of that name in data/displays or data/trackers, without .toml, or
// by a path, which has a slash in it or ends with .toml. Errors are of type Error and say
// file:line:column for bad TOML, unknown keys, missing ones, wrong types and values out of range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/known_duration.h"
#include "renderer/gaze/open_gaze_records.h"
#include "renderer/gaze/screen.h"

namespace foveola {

enum class DisplayKind {
  headset,  ///< two views side by side, each through a lens
  monitor   ///< one flat view
};

/// A point of a view that a lens shows at distance r from its axis, as a tangent, has to be drawn
/// at r (1 + k1 r^2 + k2 r^4) (Brown 1966).
struct LensDistortion {
  double k1 = 0.0;
  double k2 = 0.0;
};

struct DisplayProfile {
  std::string name;  ///< the file's, without .toml
  std::string title;
  DisplayKind kind = DisplayKind::monitor;
  int width_px = 0;  ///< of the whole display; even for a headset
  int height_px = 0;
  double refresh_rate_hz = 0.0;
  double horizontal_fov_deg = 0.0;  ///< of one view, in (0, 180); a monitor's by its geometry
  double vertical_fov_deg = 0.0;
  double width_m = 0.0;  ///< of a monitor; 0 for a headset, as the next two
  double height_m = 0.0;
  double viewing_distance_m = 0.0;
  std::optional<LensDistortion> lens;  ///< of a headset whose lenses are known
  KnownDuration scan_out;              ///< from a frame's presentation until all of it is lit
  std::string toml;                    ///< the file's content, for the record
};

enum class TrackerSource { hid, open_gaze, simulated };

struct TrackerProfile {
  std::string name;  ///< the file's, without .toml
  std::string title;
  TrackerSource source = TrackerSource::simulated;
  double rate_hz = 0.0;
  KnownDuration exposure;
  KnownDuration transfer;
  KnownDuration processing;
  OpenGazeAddress open_gaze;           ///< where an open_gaze source listens
  SimulatedTrackerSettings simulated;  ///< what a simulated source does, with seed 0
  std::string toml;                    ///< the file's content, for the record
};

DisplayProfile read_display_profile(const std::string& name_or_path);
TrackerProfile read_tracker_profile(const std::string& name_or_path);

/// The program's own, in alphabetical order.
std::vector<std::string> display_profile_names();
std::vector<std::string> tracker_profile_names();

/// One view of the display. Where a headset's would be is a matter of choice: a metre ahead.
Screen screen_of(const DisplayProfile& display);

}  // namespace foveola
