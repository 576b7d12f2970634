// What is known of displays and trackers: TOML files, chosen by name.
//
// A profile is named by the file of that name in data/displays or data/trackers, without .toml, or
// by a path, which has a slash in it or ends with .toml. Errors are of type Error and say
// file:line:column for bad TOML, unknown keys, missing ones, wrong types and values out of range.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/latency.h"
#include "renderer/gaze/open_gaze/open_gaze_records.h"
#include "renderer/view/viewport.h"

namespace foveola {

class TomlKeys;
class TomlReader;

/// What a display was found to be with instruments; what was not measured is empty.
struct MeasuredDisplay {
  std::string date;                   ///< as its file says
  std::string instrument;             ///< what it was measured with
  std::optional<double> white_cd_m2;  ///< luminance of white in the middle
  std::optional<double> black_cd_m2;
  std::optional<double> gamma;  ///< the exponent from pixel values to luminance
  std::optional<double> refresh_rate_hz;
};

enum class WindowCorner { top_left, top_right, bottom_left, bottom_right };

/// "top left" and so on, as profiles have it.
const char* name_of(WindowCorner corner);

/// A square in a corner of the window that is black, and white from the first frame of a trial
/// until its last, for a photodiode: so it can be proven when the display showed them.
struct TimingPatch {
  WindowCorner corner = WindowCorner::bottom_left;
  int size_px = 64;  ///< its side
};

enum class DisplayKind {
  headset,  ///< two views side by side in a window, each through a lens
  monitor,  ///< one flat view
  openxr    ///< a headset by OpenXR, whose runtime tells all else of it
};

struct DisplayProfile {
  std::string name;  ///< the file's, without .toml
  std::string title;
  DisplayKind kind = DisplayKind::monitor;
  int width_px = 0;  ///< width of the whole display, in a headset of both views together
  int height_px = 0;
  double refresh_rate_hz = 0.0;
  double horizontal_fov_deg =
      0.0;  ///< one view's, in (0, 180); a monitor's follows from its geometry
  double vertical_fov_deg = 0.0;
  double width_m = 0.0;  ///< a monitor's width; 0 for a headset, as the next two are
  double height_m = 0.0;
  double viewing_distance_m = 0.0;
  /// The left eye's, of a headset whose lenses are known; by OpenXR, what holds both eyes' views.
  std::optional<RadialLens> lens;
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< of a view, by OpenXR; null: all of it
  std::optional<MeasuredDisplay> measured;
  std::optional<TimingPatch> timing_patch;
  KnownDuration scan_out;  ///< time from a frame's presentation until all of it is lit
  std::string toml;        ///< the file's content, for the record
};

enum class TrackerSource { hid, open_gaze, openxr, pointer, recorded, simulated };

/// "open-gaze" and so on, as profiles have it.
const char* name_of(TrackerSource source);

struct TrackerProfile {
  std::string name;  ///< the file's, without .toml
  std::string title;
  TrackerSource source = TrackerSource::simulated;
  double rate_hz = 0.0;
  KnownDuration exposure;
  KnownDuration transfer;
  KnownDuration processing;
  OpenGazeAddress open_gaze;           ///< where an open_gaze source listens
  std::filesystem::path recording;     ///< what a recorded source replays: see read_gaze_file
  SimulatedTrackerSettings simulated;  ///< what a simulated source does, with seed 0
  std::string toml;                    ///< the file's content, for the record
};

/// Whether it is a path; a name otherwise.
bool is_profile_path(const std::string& name_or_path);

/// The shortest time from the middle of an exposure, which a sample is of, until it can be here.
Nanoseconds shortest_delay(const TrackerProfile& profile);

DisplayProfile read_display_profile(const std::string& name_or_path);

/// A recording must lie in the profile's folder: see confined_path().
TrackerProfile read_tracker_profile(const std::string& name_or_path);

/// Profiles from texts that were kept, without a name; `where` names them in messages.
DisplayProfile display_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys = nullptr);
TrackerProfile tracker_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys = nullptr);

/// The program's own, in alphabetical order.
std::vector<std::string> tracker_profile_names();

/// The keys of a lens that `table` has, over those of `lens`: axis, a list of two; k1 and k2.
RadialLens read_lens(TomlReader& table, RadialLens lens);

/// One view of the display. Where a headset's would be is a matter of choice: a metre ahead.
Screen screen_of(const DisplayProfile& display);

}  // namespace foveola
