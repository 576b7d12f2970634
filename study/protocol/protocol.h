// A study as its researcher wrote it down: TOML in, validated values out.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/profiles.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "renderer/view/weight_image.h"
#include "study/protocol/questionnaire.h"

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
  double adaptive_contrast = 0.0;
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
  double mark_timeout_s = 120.0;  ///< from the first frame; marks that have not come are censored
  double rating_s = 4.0;          ///< how long a participant looks around before rating, at least
};

/// How the rows of a design are made. Latin and Williams squares are as large as what they order.
enum class Order {
  fixed,     ///< as the protocol lists it
  random,    ///< drawn anew for every participant; as published
  latin,     ///< the rows of a cyclic Latin square
  williams,  ///< balanced for what precedes what
};

/// A moment that the participant marks while a trial is rendered; the marks come in the protocol's
/// order.
struct MarkEntry {
  std::string id;           ///< "outline", "material"
  std::string instruction;  ///< what the participant reads before the trial
};

/// For how long a trial's object is kept.
enum class ObjectChoice { per_scene, per_method };

/// What a trial is shown with.
struct TrialSettings {
  FilmSettings film;
  Timing timing;
  bool fill_unsampled = false;
};

/// A trial to get used to it, in one of the study's scenes, with one of its methods.
struct PracticeEntry {
  std::string scene;
  std::string method;
};

/// Trials in which nothing is rendered.
struct CatchTrials {
  int count = 0;           ///< in a session, at places that the seed draws
  double timeout_s = 8.0;  ///< after which each ends by itself
};

struct ReactionSettings {
  int presses = 10;
  double shortest_wait_s = 1.0;  ///< drawn uniformly between these, so that nobody can guess
  double longest_wait_s = 3.0;
};

/// A part of a session: "consent", "validation", "reaction", "trials" (with the practice before
/// them), or a questionnaire.
struct PhaseEntry {
  enum class Kind { consent, questionnaire, validation, reaction, trials };
  Kind kind = Kind::trials;
  std::string questionnaire;  ///< its id
};

/// A comparison that the analysis plan names before there are data.
struct PlannedComparison {
  std::string measure;   ///< a mark's id, or that of a rating in numbers
  std::string method;    ///< compared with `baseline`
  std::string baseline;  ///< a method of the protocol
};

/// The preregistered part of the analysis: anything else is exploratory.
struct AnalysisPlan {
  std::vector<PlannedComparison> primary;
  double alpha = 0.05;
  /// Of equivalence tests, per measure: the largest difference that does not matter. Times as a
  /// ratio above 1, ratings in points.
  std::map<std::string, double> equivalence_margins;
  std::optional<int> participants;  ///< as many are planned
};

/// How well a simulation knows what the image will converge to.
struct ReferenceQuality {
  int samples_per_pixel = 32;
  int samples_per_object = 3'000'000;
};

struct Protocol {
  std::string name;
  std::string title;
  std::string language = "en";     ///< BCP 47, of the texts
  Texts texts;                     ///< screens' words over the built-in ones
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
  Order scene_order = Order::random;
  Order method_order = Order::random;  ///< within each scene
  ObjectChoice object_choice = ObjectChoice::per_scene;
  std::vector<MarkEntry> marks;   ///< at least one; default: outline, material
  std::vector<Question> ratings;  ///< after the marks; default: "artifacts", 1 to 5
  std::vector<PracticeEntry> practice;
  CatchTrials catch_trials;
  std::optional<ReactionSettings> reaction;
  std::vector<Questionnaire> questionnaires;
  std::vector<PhaseEntry> phases;  ///< in the session's order; exactly one is trials
  /// By scene and method, where overrides say something else than film, timing and display.
  std::map<std::pair<std::string, std::string>, TrialSettings> cells;
  AnalysisPlan analysis;

  /// A line for each key that stands under the name that it had in an earlier version.
  std::vector<std::string> notes;

  std::filesystem::path path;
  std::string text;    ///< the file, to the letter
  std::string sha256;  ///< of the text
};

/// A protocol's file: `name_or_path` itself if that is a file, else protocols/NAME.toml of the
/// resource folder. Throws Error, listing the known names, if there is neither.
std::filesystem::path find_protocol(const std::string& name_or_path);

/// Only name, title, scenes and methods must be given; the rest has the defaults above. Files of
/// methods are read now, and only inside the protocol's own folder, as are profiles and
/// questionnaires that it names by a path. Throws Error with file:line:column for an unknown key, a
/// wrong type, an impossible value or a bad file.
Protocol load_protocol(const std::filesystem::path& path);

/// The same of a text that was kept; `path` says where it was, for messages and for the files that
/// it names.
Protocol read_protocol(const std::string& text, const std::filesystem::path& path);

/// Where the files lie that the protocol names by their paths.
std::filesystem::path folder_of(const Protocol& protocol);

/// As the protocol writes them: "latin"; "trials", or a questionnaire's id.
std::string name_of(Order order);
std::string name_of(const PhaseEntry& phase);

/// What a trial of this scene and method is shown with: the protocol's settings, then the scene's,
/// then the method's, then those of both, each of them only where it says something.
TrialSettings settings_of(const Protocol& protocol, const std::string& scene,
                          const std::string& method);

/// The questionnaire of this id, which the protocol has.
const Questionnaire& questionnaire_of(const Protocol& protocol, const std::string& id);

/// The TOML of the files that come with Foveola or lie beside the protocol, by what they are of:
/// "display", "tracker", "questionnaire".
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
