// Profiles of displays and trackers: TOML files, chosen by name.
//
// A profile's name is that of its file in data/displays or data/trackers, without .toml, or a path
// with a slash or with the ending .toml. Throws Error with file:line:column for bad TOML, unknown
// or missing keys, wrong types and values out of range.
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

/// A display's properties as measured with instruments; empty if not measured.
struct MeasuredDisplay {
  std::string date;                   ///< as in the file
  std::string instrument;             ///< name of the instrument
  std::optional<double> white_cd_m2;  ///< luminance of white in the centre
  std::optional<double> black_cd_m2;
  std::optional<double> gamma;  ///< exponent from pixel values to luminance
  std::optional<double> refresh_rate_hz;
};

enum class WindowCorner { top_left, top_right, bottom_left, bottom_right };

/// "top left" and so on, as in profiles.
const char* name_of(WindowCorner corner);

/// A square in a corner of the window, white from the first frame of a trial until its last and
/// black otherwise. A photodiode on it proves when the display showed them.
struct TimingPatch {
  WindowCorner corner = WindowCorner::bottom_left;
  int size_px = 64;  ///< length of a side
};

enum class DisplayKind {
  headset,  ///< two views side by side in a window, each behind a lens
  monitor,  ///< one flat view
  openxr    ///< a headset by OpenXR, whose runtime gives all other properties
};

struct DisplayProfile {
  std::string name;  ///< the file's name, without .toml
  std::string title;
  DisplayKind kind = DisplayKind::monitor;
  int width_px = 0;  ///< width of the whole display; of a headset, both views together
  int height_px = 0;
  double refresh_rate_hz = 0.0;
  double horizontal_fov_deg =
      0.0;  ///< of one view, in (0, 180); a monitor's follows from its geometry
  double vertical_fov_deg = 0.0;
  double width_m = 0.0;  ///< a monitor's width; 0 for a headset, like the next two
  double height_m = 0.0;
  double viewing_distance_m = 0.0;
  /// The left eye's lens of a headset, if known; for OpenXR, the view that holds both eyes' views.
  std::optional<RadialLens> lens;
  std::shared_ptr<const SeenPart> seen = nullptr;  ///< of a view, by OpenXR; null: the whole view
  std::optional<MeasuredDisplay> measured;
  std::optional<TimingPatch> timing_patch;
  KnownDuration scan_out;  ///< time from a frame's presentation until all of it is lit
  std::string toml;        ///< the file's content, for the record
};

enum class TrackerSource { hid, open_gaze, openxr, pointer, recorded, simulated };

/// "open-gaze" and so on, as in profiles.
const char* name_of(TrackerSource source);

struct TrackerProfile {
  std::string name;  ///< the file's name, without .toml
  std::string title;
  TrackerSource source = TrackerSource::simulated;
  double rate_hz = 0.0;
  KnownDuration exposure;
  KnownDuration transfer;
  KnownDuration processing;
  OpenGazeAddress open_gaze;           ///< address of an open_gaze source
  std::filesystem::path recording;     ///< file of a recorded source: see read_gaze_file
  SimulatedTrackerSettings simulated;  ///< of a simulated source, with seed 0
  std::string toml;                    ///< the file's content, for the record
};

/// Whether it is a path and not a name.
bool is_profile_path(const std::string& name_or_path);

/// Minimum delay from a sample's time, the middle of its exposure, to its arrival.
Nanoseconds shortest_delay(const TrackerProfile& profile);

DisplayProfile read_display_profile(const std::string& name_or_path);

/// A recording must be in the profile's folder: see confined_path().
TrackerProfile read_tracker_profile(const std::string& name_or_path);

/// Nameless profiles from stored texts; `where` names them in messages.
DisplayProfile display_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys = nullptr);
TrackerProfile tracker_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys = nullptr);

/// The program's own profiles, in alphabetical order.
std::vector<std::string> tracker_profile_names();

/// Reads the keys of a lens in `table` over those of `lens`: axis, a list of two; k1 and k2.
RadialLens read_lens(TomlReader& table, RadialLens lens);

/// One view of the display. A headset's is placed by choice a metre ahead.
Screen screen_of(const DisplayProfile& display);

}  // namespace foveola
