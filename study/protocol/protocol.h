// A study's protocol: the researcher's TOML file as validated values.
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

/// A scene that the protocol names, with its place in the file.
struct SceneEntry {
  std::string name;
  int line = 0;
  int column = 0;
};

/// A method's file, as it was when the protocol was loaded.
struct MethodFile {
  std::string method;  ///< One of Protocol::methods.
  std::string file;    ///< As named in the method's text, relative to the protocol's folder.
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
  /// Fields of view without the lens. If the protocol has only one, its pixels are square.
  double horizontal_fov_deg = 100.0;
  double vertical_fov_deg = 100.0;
  RadialLens lens;              ///< The lens before the eye that the protocol simulates.
  bool fill_unsampled = false;  ///< From the film's pyramid; false: they are black.
};

struct FilmSettings {
  int width = 320;  ///< Pixels of the 360-degree image.
  int height = 160;
  /// Maximum number of surface vertices of a path: half of a render's. The paper gives none.
  int max_depth = 4;
  /// Adaptive sampling: pixels below this VisibleNoise::contrast get no more samples. 0, as
  /// published: all pixels get samples.
  double adaptive_contrast = 0.0;

  friend bool operator==(const FilmSettings&, const FilmSettings&) = default;
};

/// Returns the memory in bytes of a fully sampled film: 32 bytes per pixel (FilmTile::Pixel), and
/// 512 bytes for each 8 x 8 pixels and each 32 x 32 (FilmTile::Node).
constexpr double memory_of(const FilmSettings& film) {
  return (32.0 + 512.0 / 64.0 + 512.0 / 1024.0) * film.width * film.height;
}

/// Validation of the gaze: before the trials, participants look at targets. The session continues
/// only if the tracker's accuracy, precision and loss of data are good enough.
struct ValidationSettings {
  int points = 9;  ///< 9 or 5 targets.
  GazeGate gate;
  bool correct = false;  ///< Calibrate first, and correct the gaze by the result.
  int attempts = 3;      ///< The session ends after this many failed attempts.
};

struct TrackerSettings {
  std::optional<TrackerProfile> profile;
  SimulatedTrackerSettings simulated;  ///< The tracker of simulated participants; seed 0.
  std::optional<ValidationSettings> validation;
  /// Filter of the gaze before frames use it. The record also keeps the unfiltered gaze, which is
  /// validated.
  GazeFilterSettings filter;
};

/// The picture's behaviour while the participant answers a trial's ratings.
enum class WhileRating {
  converges,  ///< More samples are added, as before.
  held,       ///< It stays as it was at the first question.
  blank,      ///< It is black.
};

struct Timing {
  double mark_timeout_s = 120.0;  ///< From the first frame; later marks are right-censored.
  double rating_s = 4.0;          ///< Minimum time for looking around before rating.
  WhileRating while_rating = WhileRating::converges;

  friend bool operator==(const Timing&, const Timing&) = default;
};

/// The source of participants' orders.
enum class Order {
  fixed,     ///< As listed in the protocol.
  random,    ///< Drawn anew for every participant, as published.
  latin,     ///< The rows of a cyclic Latin square.
  williams,  ///< The rows of a Williams square, which is balanced for carry-over.
};

/// A moment that the participant marks while a trial is rendered, in the protocol's order.
struct MarkEntry {
  std::string id;           ///< As "outline" or "material".
  std::string instruction;  ///< The text that the participant reads before the trial.
  /// Judgement by which simulated participants make the mark: "outline" or "material"; empty if
  /// there is none.
  std::string simulated;
};

/// The scope of a chosen object.
enum class ObjectChoice { per_scene, per_method };

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

/// Consequence of a mark while the participant did not see the trial's object.
enum class Remedy {
  flag,    ///< A note in the record and the analysis.
  retime,  ///< The trial is also retimed, up to max_retimings times.
};

/// Maximum number of retimings because the object was not looked at: participants who then still
/// look elsewhere have a reason.
inline constexpr int max_retimings = 2;

/// Consequences of not looking at a trial's object.
struct LookingSettings {
  Remedy object_out_of_view = Remedy::flag;  ///< The view did not show the object at a mark.
  Remedy gaze_elsewhere = Remedy::flag;      ///< The gaze was elsewhere for most of the trial.
};

/// Requirements before a person's session begins; empty ones are not checked.
struct PreflightGate {
  std::optional<double> max_late_percent;        ///< Frames that miss their refresh, in each scene.
  std::optional<double> min_samples_per_second;  ///< Of the slowest method and scene.
  std::optional<double> min_gaze_rate_hz;
  std::optional<double> max_gaze_loss;   ///< Fraction of invalid samples, in [0, 1].
  std::optional<double> max_gaze_age_s;  ///< Median age of the newest sample in a frame.
  std::optional<double> min_free_gb;     ///< On the disk of the study's file, in 10^9 bytes.
  bool tracked_eye = false;              ///< Not simulated, not recorded, and not the pointer.
  bool stated_display = false;           ///< The display matches its profile.
  std::optional<Vec2> fov_deg;           ///< Fields of view of the window, across and up.
  double fov_tolerance_deg = 0.5;
  bool full_screen = false;
  bool same_machine =
      false;  ///< As in people's earlier sessions: processor, graphics, threads, speed.
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

/// A comparison of the preregistered analysis plan.
struct PlannedComparison {
  std::string measure;   ///< The id of a mark, or of a rating in numbers.
  std::string method;    ///< Compared with `baseline`.
  std::string baseline;  ///< A method of the protocol.
};

/// Whether comparisons of times generalise to other scenes, or hold for the study's scenes only.
enum class SceneEffects { random, fixed };

/// The primary analysis of ratings.
enum class RatingAnalysis { ordinal_model, signed_ranks };

/// The preregistered part of the analysis; any other comparison is exploratory.
struct AnalysisPlan {
  std::vector<PlannedComparison> primary;
  double alpha = 0.05;
  SceneEffects scenes = SceneEffects::random;
  RatingAnalysis ratings = RatingAnalysis::ordinal_model;
  /// Margins of equivalence tests by measure, the largest difference that does not matter: a ratio
  /// above 1 for times, points for ratings.
  std::map<std::string, double> equivalence_margins;
  /// Numeric questions of the questionnaire "background", whose mean answer is a participant's
  /// background; empty: background is not analysed.
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
  Texts texts;                     ///< The texts that replace built-in ones.
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
  /// Settings by scene and method that overrides change.
  std::map<std::pair<std::string, std::string>, TrialSettings> cells;
  AnalysisPlan analysis;

  /// A line for each key under an outdated name.
  std::vector<std::string> notes;

  std::filesystem::path path;
  std::string text;    ///< The exact content of the file.
  std::string sha256;  ///< SHA-256 of the text.
};

/// Returns a protocol's file: `name_or_path` itself if that is a file, else protocols/NAME.toml of
/// the user's data folder, else of the resource folder. Throws Error, with the known names or a
/// similar one, if there is none.
std::filesystem::path find_protocol(const std::string& name_or_path);

/// Reads a protocol's file. Only name, title, scenes and methods are required; the rest has the
/// defaults above. Methods' files are read now, and only inside the protocol's own folder, as are
/// profiles and questionnaires named by a path. Throws Error with file:line:column for an unknown
/// key, a wrong type, an impossible value or a bad file.
Protocol load_protocol(const std::filesystem::path& path);

/// Reads a protocol from a recorded text. `path`: of its file, for messages and for the files that
/// it names. keys: see TomlReader.
Protocol read_protocol(const std::string& text, const std::filesystem::path& path,
                       TomlKeys* keys = nullptr);

/// Reads the part of a study's protocol that its analysis needs, and that no file on this machine
/// can change: scenes, methods, film and timing, orders, marks, ratings, practice and catch trials,
/// questionnaires, and the analysis plan. The rest keeps its defaults. `where` names the text in
/// messages; `files` has the questionnaires' files.
Protocol read_measured_part(const std::string& text, const std::string& where,
                            const std::function<std::string(const std::string& name)>& files);

/// Reads the display of a study's protocol, with the recorded text of its profile, if any: no file
/// on this machine can change it. `where` names the text in messages. Throws Error as read_protocol
/// does.
DisplaySettings read_recorded_display(const std::string& text, const std::string& where,
                                      const std::string& profile_toml);

/// Returns the folder of the files that the protocol names by paths.
std::filesystem::path folder_of(const Protocol& protocol);

/// Return names in a protocol: "latin"; "trials", or a questionnaire's id.
std::string name_of(Order order);
std::string name_of(SceneEffects scenes);
std::string name_of(RatingAnalysis analysis);
std::string name_of(const PhaseEntry& phase);

/// Returns the settings of a trial of this scene and method: the protocol's, overridden by the
/// scene's, then the method's, then those of both, each only for the keys that it has.
TrialSettings settings_of(const Protocol& protocol, const std::string& scene,
                          const std::string& method);

/// Returns the questionnaire of this id, which must exist.
const Questionnaire& questionnaire_of(const Protocol& protocol, const std::string& id);

/// A TOML file that the protocol names, from Foveola or the protocol's folder. `device`: "display",
/// "tracker" or "questionnaire".
struct NamedProfile {
  std::string device;
  std::string name;
  std::string toml;
};
std::vector<NamedProfile> named_profiles(const Protocol& protocol);

/// Return the index of a scene or a method of the protocol.
std::size_t scene_index(const Protocol& protocol, const std::string& name);
std::size_t method_index(const Protocol& protocol, const std::string& name);

/// Makes the sampler of one of the protocol's methods, from its loaded files: changes on the disk
/// while a study runs have no effect.
std::unique_ptr<ViewSampler> make_sampler(const Protocol& protocol, const std::string& method);

/// Finds a scene of the protocol, beside the protocol first. Throws Error with file:line:column if
/// it cannot be found, has no viewpoint, or has no objects to choose.
SceneSource find_scene_of(const Protocol& protocol, const SceneEntry& entry,
                          const SceneFinderBeside& find_scene);
std::vector<SceneSource> find_scenes(const Protocol& protocol, const SceneFinderBeside& find_scene);

}  // namespace foveola::study
