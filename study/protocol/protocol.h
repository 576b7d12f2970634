// A study as its researcher wrote it down: TOML in, validated values out.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/profiles.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "renderer/view/weight_image.h"

namespace foveola::study {

/// A scene that the protocol names, and where it does.
struct SceneEntry {
  std::string name;
  int line = 0;
  int column = 0;
};

/// A file that a method reads, as it was when the protocol was loaded.
struct MethodFile {
  std::string method;  ///< of Protocol::methods
  std::string file;    ///< as the method's text names it, relative to the protocol's folder
  std::string sha256;
  std::shared_ptr<const WeightImage> weights;
};

/// A question of the background questionnaire, answered with a whole number.
struct Question {
  std::string id;
  std::string text;
  int minimum = 1;
  int maximum = 5;
};

/// The machine whose speed a simulated study assumes, so that its times do not depend on the host.
struct MachineModel {
  double samples_per_second = 42725.0;  ///< the published 7 million, scaled with the film's area
  double frame_rate_hz = 70.0;
};

/// What the protocol says itself stands over what its profile says, here and of the tracker.
struct DisplaySettings {
  std::optional<DisplayProfile> profile;
  int view_width = 112;  ///< pixels
  int view_height = 112;
  /// Fields of view without the lens. If the protocol says only one, its pixels are square.
  double horizontal_fov_deg = 100.0;
  double vertical_fov_deg = 100.0;
  RadialLens lens;              ///< of the eye that the protocol shows
  bool fill_unsampled = false;  ///< from the film's pyramid; the published study left them black
};

struct FilmSettings {
  int width = 320;  ///< pixels of the 360-degree image
  int height = 160;
  int max_depth = 4;  ///< surface vertices
  /// VisibleNoise::contrast of pixels that get no more samples; 0, as published: all get them.
  double spare_done_contrast = 0.0;
};

/// Before anything else, participants look at targets, and the tracker has to see it well enough.
struct ValidationSettings {
  int points = 9;  ///< or 5
  GazeGate gate;
  bool correct = false;  ///< calibrates first, and corrects the gaze by what that says
  int attempts = 3;      ///< after as many that were not good enough, the session ends
};

struct TrackerSettings {
  std::optional<TrackerProfile> profile;
  SimulatedTrackerSettings simulated;  ///< what simulated participants are watched with; seed 0
  std::optional<ValidationSettings> validation;
};

struct Timing {
  double mark_timeout_s = 120.0;  ///< a mark that has not come by then is censored
  double rating_s = 4.0;          ///< how long a participant looks around before rating
};

/// How well a simulation knows what the image will converge to.
struct ReferenceQuality {
  int samples_per_pixel = 32;
  int samples_per_object = 300'000;
};

struct Protocol {
  std::string name;
  std::string title;
  std::vector<SceneEntry> scenes;  ///< at least one, none twice
  std::vector<std::string>
      methods;  ///< as make_view_sampler reads them, none twice; first: baseline
  std::vector<MethodFile> method_files;  ///< in the methods' order; none twice for one method
  MachineModel machine;
  DisplaySettings display;
  FilmSettings film;
  TrackerSettings tracker;
  Timing timing;
  ReferenceQuality reference;
  std::vector<Question> background;

  std::filesystem::path path;
  std::string text;    ///< the file, to the letter
  std::string sha256;  ///< of the text
};

/// A protocol's file: `name_or_path` itself if that is a file, else protocols/NAME.toml of the
/// resource folder. Throws Error, listing the known names, if there is neither.
std::filesystem::path find_protocol(const std::string& name_or_path);

/// Only name, title, scenes and methods must be given; the rest has the defaults above. Files of
/// methods are read now, and only inside the protocol's own folder, as are profiles that it names
/// by a path. Throws Error with file:line:column for an unknown key, a wrong type, an impossible
/// value or a bad file.
Protocol load_protocol(const std::filesystem::path& path);

/// The TOML of the profiles that the protocol names, by what they are of: "display", "tracker".
struct NamedProfile {
  std::string device;
  std::string name;
  std::string toml;
};
std::vector<NamedProfile> named_profiles(const Protocol& protocol);

/// The sampler of one of the protocol's methods, from the files as they were loaded: what changes
/// on the disk while a study runs changes nothing.
std::unique_ptr<ViewSampler> make_sampler(const Protocol& protocol, const std::string& method);

/// Finds every scene of the protocol, in its order. Throws Error with file:line:column for one that
/// cannot be found or that names no objects to choose.
std::vector<SceneSource> find_scenes(const Protocol& protocol, const SceneFinder& find_scene);

}  // namespace foveola::study
