// The options of `preview`, and their interpretation before anything is loaded.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/command_line/cli_fwd.h"
#include "renderer/commands/arguments.h"
#include "renderer/commands/look_options.h"
#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/gaze_filter.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/live/preview_controls.h"

namespace foveola {

/// As typed; empty or 0 if an option was not given.
struct PreviewArguments {
  std::string scene;
  LookArguments look;
  std::string method = "fv";
  IVec2 film_size = live_film_size;
  std::string display = "desktop";
  std::string tracker = "pointer";
  std::string gaze_file;
  std::string gaze_filter = "none";
  std::string head_file;
  std::string window = "1280x720";
  int monitor = 0;
  bool full_screen = false;
  bool true_angles = false;
  bool fill_unsampled = false;
  bool correct_gaze = false;
  std::vector<std::string> shown;
  bool watch = false;
  std::uint64_t frames = 0;
  std::string screenshot;
  TraceSettings trace;
  int threads = 0;
  bool json = false;
};

/// Adds all options to `command`; `arguments` must outlive it.
void add_preview_options(CLI::App& command, PreviewArguments& arguments);

/// The parsed request, as far as it needs neither the scene nor a window.
struct PreviewRequest {
  SceneSource source;
  SceneChoices scene;               ///< includes the first heading of a replayed head
  std::optional<FieldsOfView> fov;  ///< of the initial view
  ExposureChoice exposure;
  PreviewChoices choices;  ///< except the exposure
  ProgressiveSettings render;
  IVec2 window{0};  ///< pixels
  DisplayProfile display;
  TrackerProfile tracker;
  std::vector<GazeSample> replayed_gaze;  ///< empty: the tracker's gaze
  GazeFilterSettings gaze_filter;
  std::vector<HeadPose> replayed_head;  ///< empty: the user turns it
};

/// Throws UsageError for malformed options, and Error for missing or bad files. Of the scene's
/// files only the descriptor is read.
PreviewRequest preview_request(const PreviewArguments& arguments, const SceneFinder& find_scene);

}  // namespace foveola
