// The protocol of a study: the researcher's TOML file as validated values.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/gaze/gaze_filter.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/profiles.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "renderer/view/weight_image.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// A scene that the protocol names, with the place in the file.
struct SceneEntry {
  std::string name;
  int line = 0;
  int column = 0;
};

/// A file that a method reads, as it was when the protocol was loaded.
struct MethodFile {
  std::string method;  ///< One of Protocol::methods.
  std::string file;    ///< As the method's text names it, relative to the protocol's folder.
  std::string sha256;
  std::shared_ptr<const WeightImage> weights;
};

/// The machine whose speed a simulated study assumes, so that its times do not depend on the host.
struct MachineModel {
  double samples_per_second = 42725.0;  ///< The published 7 million, scaled by the film's area.
  double frame_rate_hz = 70.0;
};

/// The display. The protocol's own values override its profile's, as with the tracker.
struct DisplaySettings {
  std::optional<DisplayProfile> profile;
  int view_width = 112;  ///< In pixels.
  int view_height = 112;
  /// Fields of view without the lens. If the protocol says only one, its pixels are square.
  double horizontal_fov_deg = 100.0;
  double vertical_fov_deg = 100.0;
  RadialLens lens;              ///< The lens before the eye that the protocol shows.
  bool fill_unsampled = false;  ///< From the film's pyramid; else they are black.
};

struct FilmSettings {
  int width = 320;  ///< Pixels of the 360-degree image.
  int height = 160;
  /// Largest number of surface vertices of a path; 4 as published, half of a render's.
  int max_depth = 4;
  /// Adaptive sampling: pixels below this VisibleNoise::contrast get no more samples. At 0, as
  /// published, all get them.
  double adaptive_contrast = 0.0;

  friend bool operator==(const FilmSettings&, const FilmSettings&) = default;
};

/// The memory in bytes that a film takes once samples fell everywhere: 32 bytes a pixel
/// (FilmTile::Pixel), and 512 bytes above each 8 x 8 pixels and each 32 x 32 (FilmTile::Node).
constexpr double memory_of(const FilmSettings& film) {
  return (32.0 + 512.0 / 64.0 + 512.0 / 1024.0) * film.width * film.height;
}

/// Validation of the gaze: before the trials, participants look at targets, and the session goes on
/// only if the tracker's accuracy, precision and loss of data are good enough.
struct ValidationSettings {
  int points = 9;  ///< 9 or 5 targets.
  GazeGate gate;
  bool correct = false;  ///< Calibrate first, and correct the gaze by the result.
  int attempts = 3;      ///< After this many failed attempts the session ends.
};

struct TrackerSettings {
  std::optional<TrackerProfile> profile;
  SimulatedTrackerSettings simulated;  ///< The tracker of simulated participants; seed 0.
  std::optional<ValidationSettings> validation;
  /// What the gaze goes through before frames use it. The record keeps it as it came, too, and that
  /// is what is validated.
  GazeFilterSettings filter;
};

/// What the picture does while the participant answers a trial's ratings.
enum class WhileRating {
  converges,  ///< More samples come, as before.
  held,       ///< It stays as it was when the first question came.
  blank,      ///< It is black.
};

struct Timing {
  double mark_timeout_s = 120.0;  ///< From the first frame; later marks are right-censored.
  double rating_s = 4.0;          ///< The least time for looking around before rating.
  WhileRating while_rating = WhileRating::converges;

  friend bool operator==(const Timing&, const Timing&) = default;
};

/// How participants' orders are made.
enum class Order {
  fixed,     ///< As the protocol lists it.
  random,    ///< Drawn anew for every participant, as published.
  latin,     ///< The rows of a cyclic Latin square.
  williams,  ///< The rows of a Williams square, which is balanced for carry-over.
};

/// A moment that the participant marks while a trial is rendered; the marks come in the protocol's
/// order.
struct MarkEntry {
  std::string id;           ///< As "outline" or "material".
  std::string instruction;  ///< The text that the participant reads before the trial.
  /// The judgement by which simulated participants make the mark: "outline" or "material"; empty if
  /// there is none.
  std::string simulated;
};

/// For how long a trial's object is kept.
enum class ObjectChoice { per_scene, per_method };

/// The settings of one trial.
struct TrialSettings {
  FilmSettings film;
  Timing timing;
  bool fill_unsampled = false;

  friend bool operator==(const TrialSettings&, const TrialSettings&) = default;
};

/// A practice trial, in one of the study's scenes, with one of its methods.
struct PracticeEntry {
  std::string scene;
  std::string method;
};

/// Trials in which nothing is rendered.
struct CatchTrials {
  int count = 0;           ///< Number in a session, at random positions.
  double timeout_s = 8.0;  ///< Time after which each ends by itself.
};

struct ReactionSettings {
  int presses = 10;
  double shortest_wait_s = 1.0;  ///< Waits are drawn uniformly, so that nobody can anticipate them.
  double longest_wait_s = 3.0;
};

/// What follows when a mark shows that a participant did not see the trial's object.
enum class Remedy {
  flag,    ///< A note in the record says so, and the analysis.
  retime,  ///< The trial is timed again as well, up to max_retimings times.
};

/// How often a trial is timed again because the object was not looked at: whoever then still looks
/// elsewhere has a reason for it.
inline constexpr int max_retimings = 2;

/// What follows when a participant did not look at a trial's object.
struct LookingSettings {
  Remedy object_out_of_view = Remedy::flag;  ///< The view did not show the object at a mark.
  Remedy gaze_elsewhere = Remedy::flag;      ///< The gaze was elsewhere for most of the trial.
};

/// What has to hold before a person's session begins; what is empty is not asked for.
struct PreflightGate {
  std::optional<double> max_late_percent;        ///< Frames that miss their refresh, in each scene.
  std::optional<double> min_samples_per_second;  ///< Of the slowest method and scene.
  std::optional<double> min_gaze_rate_hz;
  std::optional<double> max_gaze_loss;   ///< The part of samples that are not valid, in [0, 1].
  std::optional<double> max_gaze_age_s;  ///< The median age of the newest sample in a frame.
  std::optional<double> min_free_gb;     ///< On the disk of the study's file, in 10^9 bytes.
  bool tracked_eye = false;              ///< Neither simulated nor recorded nor the pointer.
  bool stated_display = false;           ///< The display is as its profile states.
  std::optional<Vec2> fov_deg;           ///< What the window shows, across and up.
  double fov_tolerance_deg = 0.5;
  bool full_screen = false;
  bool same_machine = false;  ///< As people's sessions before: processor, graphics, threads, speed.
  bool same_display = false;  ///< Likewise: profile, pixels, size, distance, angles.
  bool set_clock = false;     ///< The system's clock is synchronised.
};

/// A part of a session: "consent", "validation", "reaction", "trials" (with the practice before
/// them), or a questionnaire.
struct PhaseEntry {
  enum class Kind { consent, questionnaire, validation, reaction, trials };
  Kind kind = Kind::trials;
  std::string questionnaire;  ///< The questionnaire's id.
};

/// A comparison that the analysis plan names before there are data.
struct PlannedComparison {
  std::string measure;   ///< The id of a mark, or of a rating in numbers.
  std::string method;    ///< Compared with `baseline`.
  std::string baseline;  ///< A method of the protocol.
};

/// Whether the comparisons of times speak of the study's scenes alone, or of others like them.
enum class SceneEffects { random, fixed };

/// The analysis that the comparisons of ratings are read from.
enum class RatingAnalysis { ordinal_model, signed_ranks };

/// The preregistered part of the analysis; any other comparison is exploratory.
struct AnalysisPlan {
  std::vector<PlannedComparison> primary;
  double alpha = 0.05;
  SceneEffects scenes = SceneEffects::random;
  RatingAnalysis ratings = RatingAnalysis::ordinal_model;
  /// The margin of equivalence tests by measure, the largest difference that does not matter: a
  /// ratio above 1 for times, points for ratings.
  std::map<std::string, double> equivalence_margins;
  /// Questions in numbers of the questionnaire "background", whose mean answer is a participant's
  /// background; empty: no scale is stated, and nothing is held against one.
  std::vector<std::string> background;
  std::optional<int> participants;  ///< The planned number.
};

/// The quality of the reference images that simulated participants expect.
struct ReferenceQuality {
  int samples_per_pixel = 32;
  int samples_per_object = 3'000'000;
};

struct Protocol {
  std::string name;
  std::string title;
  std::string language = "en";     ///< BCP 47 tag of the texts.
  Texts texts;                     ///< The words of screens that replace built-in ones.
  std::vector<SceneEntry> scenes;  ///< At least one, without duplicates.
  /// As make_view_sampler reads them, without duplicates; the first is the baseline.
  std::vector<std::string> methods;
  std::vector<MethodFile> method_files;  ///< In the methods' order, without duplicates.
  MachineModel machine;
  DisplaySettings display;
  FilmSettings film;
  TrackerSettings tracker;
  Timing timing;
  ReferenceQuality reference;
  Order scene_order = Order::random;
  Order method_order = Order::random;  ///< Within each scene.
  ObjectChoice object_choice = ObjectChoice::per_scene;
  std::vector<MarkEntry> marks;   ///< At least one; default: outline, material.
  std::vector<Question> ratings;  ///< After the marks; default: "artifacts", 1 to 5.
  std::vector<PracticeEntry> practice;
  CatchTrials catch_trials;
  std::optional<ReactionSettings> reaction;
  LookingSettings looking;
  PreflightGate preflight;
  std::vector<Questionnaire> questionnaires;
  std::vector<PhaseEntry> phases;  ///< In the session's order; exactly one is trials.
  /// The settings by scene and method that overrides change.
  std::map<std::pair<std::string, std::string>, TrialSettings> cells;
  AnalysisPlan analysis;

  /// A line for each key that stands under the name that it had in an earlier version.
  std::vector<std::string> notes;

  std::filesystem::path path;
  std::string text;    ///< The exact content of the file.
  std::string sha256;  ///< SHA-256 of the text.
};

/// A protocol's file: `name_or_path` itself if that is a file, else protocols/NAME.toml of the
/// user's data folder, else of the resource folder. Throws Error, listing the known names or one
/// that may be meant, if there is none.
std::filesystem::path find_protocol(const std::string& name_or_path);

/// Only name, title, scenes and methods must be given; the rest has the defaults above. Files of
/// methods are read now, and only inside the protocol's own folder, as are profiles and
/// questionnaires that it names by a path. Throws Error with file:line:column for an unknown key, a
/// wrong type, an impossible value or a bad file.
Protocol load_protocol(const std::filesystem::path& path);

/// Reads a protocol from a text that was kept; `path` is that of its file, for messages and for the
/// files that it names. keys: see TomlReader.
Protocol read_protocol(const std::string& text, const std::filesystem::path& path,
                       TomlKeys* keys = nullptr);

/// Reads of a study's protocol what its analysis needs, and what no file on this machine can
/// change: scenes, methods, film and timing, orders, marks, ratings, practice and catch trials,
/// questionnaires, and the analysis plan. All else keeps its defaults. `where` names the text in
/// messages; `files` has the questionnaires' files.
Protocol read_measured_part(const std::string& text, const std::string& where,
                            const std::function<std::string(const std::string& name)>& files);

/// Reads the display of a study's protocol, with the text of the profile that it names, if any, as
/// the record keeps it: no file on this machine can change it. `where` names the text in messages.
/// Throws Error as read_protocol does.
DisplaySettings read_recorded_display(const std::string& text, const std::string& where,
                                      const std::string& profile_toml);

/// The folder of the files that the protocol names by their paths.
std::filesystem::path folder_of(const Protocol& protocol);

/// The names in a protocol: "latin"; "trials", or a questionnaire's id.
std::string name_of(Order order);
std::string name_of(SceneEffects scenes);
std::string name_of(RatingAnalysis analysis);
std::string name_of(const PhaseEntry& phase);

/// The settings of a trial of this scene and method: the protocol's, overridden by the scene's,
/// then the method's, then those of both, each only for the keys that it has.
TrialSettings settings_of(const Protocol& protocol, const std::string& scene,
                          const std::string& method);

/// The questionnaire of this id, which must exist.
const Questionnaire& questionnaire_of(const Protocol& protocol, const std::string& id);

/// A file that the protocol names, which comes with Foveola or lies in the protocol's folder, as
/// TOML. `device` is "display", "tracker" or "questionnaire".
struct NamedProfile {
  std::string device;
  std::string name;
  std::string toml;
};
std::vector<NamedProfile> named_profiles(const Protocol& protocol);

/// Where a scene or a method of the protocol stands in its list.
std::size_t scene_index(const Protocol& protocol, const std::string& name);
std::size_t method_index(const Protocol& protocol, const std::string& name);

/// The sampler of one of the protocol's methods, from the files as they were loaded: changes on the
/// disk while a study runs have no effect.
std::unique_ptr<ViewSampler> make_sampler(const Protocol& protocol, const std::string& method);

/// Finds a scene of the protocol, beside the protocol first. Throws Error with file:line:column if
/// it cannot be found, has no viewpoint, or names no objects to choose.
SceneSource find_scene_of(const Protocol& protocol, const SceneEntry& entry,
                          const SceneFinderBeside& find_scene);
/// All of them, in the protocol's order.
std::vector<SceneSource> find_scenes(const Protocol& protocol, const SceneFinderBeside& find_scene);

}  // namespace foveola::study
