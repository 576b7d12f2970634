#include "study/protocol/reading/read_settings.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr int largest_film_side = 65536;
/// A film of 23170 x 11585 pixels, 64 per degree: more than any eye resolves.
constexpr double max_film_pixels = 268'435'456.0;
constexpr int largest_view_side = 8192;
constexpr double narrowest_deg = 1.0;
constexpr double widest_deg = 170.0;
constexpr int max_samples = std::numeric_limits<int>::max();

/// Reads the profile that the table names, by `read`; empty if it names none.
template <typename Profile>
std::optional<Profile> read_profile(TomlReader& reader, std::string_view meaning,
                                    const std::function<Profile(const std::string&)>& read) {
  std::string name;
  reader.read("profile", name, meaning);
  if (!reader.has("profile")) {
    return std::nullopt;
  }
  try {
    return read(name);
  } catch (const std::runtime_error& reason) {
    reader.fail(reader.source("profile"), fmt::format("profile '{}': {}", name, reason.what()),
                "name one that comes with Foveola, or a file in the folder of the protocol");
  }
}

/// Returns a profile's name for its reader: a path begins in `folder`, and stays there. Throws as
/// confined_path does.
std::string name_beside(const fs::path& folder, const std::string& name) {
  return is_profile_path(name) ? confined_path(folder, name).string() : name;
}

/// Reads the lens of the simulated eye, over the profile's lens, which is the left eye's.
RadialLens read_eyes_lens(TomlReader reader, const RadialLens& profile) {
  const RadialLens lens = read_lens(reader, profile);
  constexpr std::array eyes{Word<bool>{"left", false}, Word<bool>{"right", true}};
  bool is_right = false;
  reader.read("eye", is_right, eyes,
              "The eye whose view is shown: the lens is given for the left eye, and mirrored for "
              "the right one.");
  reader.reject_unknown_keys();
  return is_right ? mirrored(lens) : lens;
}

void require_moderate_film(const TomlReader& reader, const FilmSettings& film) {
  if (static_cast<double>(film.width) * film.height > max_film_pixels) {
    reader.fail(reader.source(reader.has("width") ? "width" : "height"),
                fmt::format("a film of {} x {} pixels would take {:.0f} GB of memory", film.width,
                            film.height, 1e-9 * memory_of(film)),
                fmt::format("make it smaller: films have at most {:.0f} million pixels, of 11 GB",
                            1e-6 * max_film_pixels));
  }
}

void require_view(const TomlReader& reader, const DisplaySettings& display) {
  try {
    Viewport(head_orientation({}), radians(display.horizontal_fov_deg),
             radians(display.vertical_fov_deg), display.lens);
  } catch (const Error& error) {
    reader.fail(reader.has("lens") ? reader.source("lens") : reader.source(), error.what(),
                "measure the headset's profile anew");
  }
}

/// Reports errors through `reader`. The view's size must have been read.
void read_fields_of_view(TomlReader& reader, DisplaySettings& display) {
  // The fields of view of an OpenXR headset are unknown before it is connected.
  const bool knows_views = display.profile && display.profile->kind != DisplayKind::openxr;
  if (knows_views && !reader.has("fov_deg")) {
    display.horizontal_fov_deg = display.profile->horizontal_fov_deg;
    display.vertical_fov_deg = display.profile->vertical_fov_deg;
    return;
  }
  constexpr const char* meaning =
      "The view's field of view in degrees: one number for square pixels, or the "
      "horizontal and the vertical one. Default: the profile's, or 100.";
  if (reader.is_array("fov_deg")) {
    Vec2 both(0.0F);
    reader.read("fov_deg", both, narrowest_deg, widest_deg, meaning);
    display.horizontal_fov_deg = both.x;
    display.vertical_fov_deg = both.y;
    return;
  }
  reader.read("fov_deg", display.horizontal_fov_deg, narrowest_deg, widest_deg, meaning);
  display.vertical_fov_deg = display.horizontal_fov_deg;
  if (display.view_width != display.view_height) {
    const double aspect = static_cast<double>(display.view_height) / display.view_width;
    display.vertical_fov_deg = fov_across_deg(aspect, display.horizontal_fov_deg);
  }
}

ValidationSettings read_validation(TomlReader reader) {
  constexpr double largest_deg = 45.0;
  ValidationSettings validation;
  reader.read("points", validation.points, {5, 9}, "The number of targets.");
  reader.read("max_accuracy_deg", validation.gate.max_accuracy_deg, 0.0, largest_deg,
              "The maximum mean angle between gaze and targets, in degrees.");
  reader.read("max_precision_deg", validation.gate.max_precision_deg, 0.0, largest_deg,
              "The maximum root mean square angle between successive samples, in degrees.");
  reader.read("max_data_loss", validation.gate.max_data_loss, 0.0, 1.0,
              "The maximum fraction of samples without a gaze.");
  reader.read("correct", validation.correct,
              "Whether the gaze is calibrated first and corrected by the result.");
  reader.read("attempts", validation.attempts, 1, 100, "The maximum number of attempts.");
  reader.reject_unknown_keys();
  return validation;
}

/// Keeps `value`, which may be optional, if the key is absent.
template <typename Value>
void read_in(TomlReader& reader, const TomlKeyName& key, const SettingRange& range, Value& value,
             std::string_view meaning) {
  reader.read(key, value, range.least, range.most, meaning);
}

OneEuroSettings read_one_euro(TomlReader reader) {
  OneEuroSettings one_euro;
  read_in(reader, "min_cutoff_hz", cutoff_range_hz, one_euro.min_cutoff_hz,
          "The cutoff frequency of the low pass for an eye at rest.");
  read_in(reader, "beta_per_deg", beta_range_per_deg, one_euro.beta_per_deg,
          "Rise of the cutoff frequency, in hertz per degree per second.");
  read_in(reader, "derivative_cutoff_hz", cutoff_range_hz, one_euro.derivative_cutoff_hz,
          "The cutoff frequency of the low pass of the velocity.");
  reader.reject_unknown_keys();
  return one_euro;
}

GazeFilterSettings read_filter(TomlReader reader) {
  GazeFilterSettings filter;
  reader.read_table("one_euro", filter.one_euro, read_one_euro,
                    "Smooth the gaze by the 1-Euro filter (Casiez, Roussel and Vogel 2012).");
  read_in(
      reader, "extrapolate_s", horizon_range_s, filter.extrapolate_s,
      "Between saccades, extrapolate the gaze by the eye's movement in this many seconds, to make "
      "up for the age of the gaze.");
  read_in(reader, "hold_s", hold_range_s, filter.hold_s,
          "While there is no valid gaze, the last one counts as valid until this age in seconds.");
  reader.reject_unknown_keys();
  if (filter == GazeFilterSettings{}) {
    reader.fail(reader.source(), "the filter has no effect",
                "add one_euro, extrapolate_s or hold_s, or remove the filter");
  }
  return filter;
}

}  // namespace

MachineModel read_machine(TomlReader reader) {
  MachineModel machine;
  reader.read("samples_per_second", machine.samples_per_second, 1.0, 1e12,
              "Samples (paths) that the machine traces per second.");
  reader.read("frame_rate_hz", machine.frame_rate_hz, 1.0, 1000.0, "Frames per second.");
  reader.reject_unknown_keys();
  return machine;
}

DisplaySettings read_display(TomlReader reader, const fs::path& folder) {
  return read_display(std::move(reader), [&](const std::string& name) {
    return read_display_profile(name_beside(folder, name));
  });
}

DisplaySettings read_display(TomlReader reader, const DisplayProfiles& profiles) {
  DisplaySettings display;
  display.profile = read_profile(reader,
                                 "The name of a profile in data/displays without .toml, or a file "
                                 "in the protocol's folder or below. Its values take the place "
                                 "of the defaults; the protocol's own keys override it.",
                                 profiles);
  reader.read("view_width", display.view_width, 8, largest_view_side,
              "Width of one eye's view in pixels.");
  reader.read("view_height", display.view_height, 8, largest_view_side,
              "Height of one eye's view in pixels.");
  read_fields_of_view(reader, display);
  reader.read("fill_unsampled", display.fill_unsampled,
              "Whether unsampled pixels are filled from their surroundings; the published study "
              "left them black.");
  display.lens =
      read_eyes_lens(reader.table("lens", "A headset's lens, which overrides the profile's."),
                     display.profile ? display.profile->lens.value_or(RadialLens{}) : RadialLens{});
  require_view(reader, display);
  reader.reject_unknown_keys();
  return display;
}

FilmSettings read_film(TomlReader reader, FilmSettings film) {
  reader.read(
      "width", film.width, 8, largest_film_side,
      "The film's width in pixels, for 360 degrees; width times height is at most 268 million.");
  reader.read("height", film.height, 4, largest_film_side,
              "The film's height in pixels, for 180 degrees; half the width for square pixels.");
  require_moderate_film(reader, film);
  reader.read("max_depth", film.max_depth, 1, 1000,
              "The maximum number of surface vertices of a path; 1 is direct light only.");
  reader.read(reader.present_name("adaptive_contrast", "spare_done_contrast"),
              film.adaptive_contrast, 0.0, 0.99,
              "Adaptive sampling: pixels whose noise, as a contrast, is below this "
              "get no more samples. At 0, as published, all pixels get them.");
  reader.reject_unknown_keys();
  return film;
}

TrackerSettings read_tracker(TomlReader reader, const fs::path& folder) {
  TrackerSettings tracker;
  tracker.profile = read_profile<TrackerProfile>(
      reader,
      "The name of a profile in data/trackers without .toml, or a file in the protocol's folder "
      "or below. Its values take the place of the defaults; the protocol's own keys override "
      "it.",
      [&](const std::string& name) { return read_tracker_profile(name_beside(folder, name)); });
  if (tracker.profile) {
    tracker.simulated = tracker.profile->simulated;
  }
  reader.read("rate_hz", tracker.simulated.rate_hz, 1.0, 10000.0,
              "Samples per second of the simulated participants' tracker.");
  reader.read(
      "latency_s", tracker.simulated.latency_s, 0.0, 1.0,
      "Latency of the simulated tracker: seconds from an eye's position until it is reported.");
  reader.read("precision_deg", tracker.simulated.precision_deg, 0.0, 10.0,
              "Precision of the simulated tracker: noise between successive samples, in degrees.");
  reader.read_table("validation", tracker.validation, read_validation,
                    "Validation of the gaze: participants look at targets; if the tracker misses "
                    "one of these limits in every attempt, the session ends.");
  reader.read_table("filter", tracker.filter, read_filter,
                    "The filter of the gaze before frames use it, also for simulated participants: "
                    "smoothed, extrapolated, then held, each only if its key is here. The record "
                    "also keeps the unfiltered gaze, which is validated.");
  reader.reject_unknown_keys();
  return tracker;
}

Timing read_timing(TomlReader reader, Timing timing) {
  constexpr std::array pictures{Word<WhileRating>{"converges", WhileRating::converges},
                                Word<WhileRating>{"held", WhileRating::held},
                                Word<WhileRating>{"blank", WhileRating::blank}};
  reader.read("mark_timeout_s", timing.mark_timeout_s, 0.1, 3600.0,
              "The time-out of marks in seconds from the first frame; marks that are not made by "
              "then are right-censored.");
  reader.read("rating_s", timing.rating_s, 0.1, 3600.0,
              "The minimum time in seconds for looking around before rating.");
  reader.read("while_rating", timing.while_rating, pictures,
              "The picture while the ratings are answered: it continues to converge, stays "
              "as it was at the first question, or is black.");
  reader.reject_unknown_keys();
  return timing;
}

ReferenceQuality read_reference(TomlReader reader) {
  ReferenceQuality reference;
  reader.read("samples_per_pixel", reference.samples_per_pixel, 1, 1 << 20,
              "Samples per pixel of the whole image.");
  reader.read("samples_per_object", reference.samples_per_object, 0, max_samples,
              "Additional samples on the chosen object.");
  reader.reject_unknown_keys();
  return reference;
}

PreflightGate read_preflight(TomlReader reader) {
  PreflightGate gate;
  reader.read("max_late_percent", gate.max_late_percent, 0.0, 100.0,
              "Maximum per cent of frames that miss their refresh, in each scene.");
  reader.read("min_samples_per_second", gate.min_samples_per_second, 1.0, 1e12,
              "Minimum samples per second of the slowest method and scene.");
  reader.read("min_gaze_rate_hz", gate.min_gaze_rate_hz, 1.0, 10000.0,
              "Minimum samples per second of the eye tracker.");
  reader.read("max_gaze_loss", gate.max_gaze_loss, 0.0, 1.0,
              "Maximum fraction of the eye tracker's samples that are invalid.");
  reader.read("max_gaze_age_s", gate.max_gaze_age_s, 0.001, 10.0,
              "Maximum median age in seconds of the newest sample when a frame uses it.");
  reader.read("min_free_gb", gate.min_free_gb, 0.0, 1e6,
              "Minimum free space in 10^9 bytes on the disk of the study's file.");
  reader.read("tracked_eye", gate.tracked_eye,
              "Whether the eye must be tracked: neither simulated, nor recorded, nor the mouse's "
              "pointer.");
  reader.read("stated_display", gate.stated_display, "Whether the display must match its profile.");
  reader.read("fov_deg", gate.fov_deg, narrowest_deg, widest_deg,
              "The horizontal and the vertical angle in degrees that the window must show.");
  reader.read("fov_tolerance_deg", gate.fov_tolerance_deg, 0.01, 45.0,
              "The tolerance of either angle in degrees.");
  reader.read("full_screen", gate.full_screen, "Whether the window must fill its monitor.");
  reader.read("same_machine", gate.same_machine,
              "Whether processor, graphics, threads, instructions and speed must be those of the "
              "study's other people, the speed within a factor of 2.");
  reader.read("same_display", gate.same_display,
              "Whether the display's profile, pixels, size in millimetres, viewing distance and "
              "angles must be those of the study's other people.");
  reader.read("set_clock", gate.set_clock, "Whether the system's clock must be synchronised.");
  reader.reject_unknown_keys();
  return gate;
}

std::string read_scene_name(TomlReader& reader, const TomlKeyName& key, const Protocol& protocol,
                            std::string_view meaning) {
  std::string name;
  reader.read(key, name, meaning);
  const bool is_known = std::ranges::any_of(
      protocol.scenes, [&](const SceneEntry& scene) { return scene.name == name; });
  if (reader.has(key) && !is_known) {
    reader.fail(reader.source(key),
                fmt::format("the scene '{}' is not one of the protocol's", name),
                "name one of the protocol's scenes");
  }
  return name;
}

std::string read_method_name(TomlReader& reader, const TomlKeyName& key, const Protocol& protocol,
                             std::string_view meaning) {
  std::string name;
  reader.read(key, name, meaning);
  const std::vector<std::string>& methods = protocol.methods;
  if (reader.has(key) && std::ranges::find(methods, name) == methods.end()) {
    reader.fail(reader.source(key),
                fmt::format("the method '{}' is not one of the protocol's", name),
                "write it as in the protocol's methods");
  }
  return name;
}

}  // namespace foveola::study
