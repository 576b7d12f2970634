#include "renderer/gaze/profiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/toml/toml_reader.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr std::string_view displays = "displays";
constexpr std::string_view trackers = "trackers";

fs::path profile_folder(std::string_view folder) { return resource_folder() / "data" / folder; }

fs::path profile_file(std::string_view folder, const std::string& name_or_path) {
  if (is_profile_path(name_or_path)) {
    return name_or_path;
  }
  const std::vector<std::string> names = toml_names_in(profile_folder(folder));
  if (std::ranges::find(names, name_or_path) == names.end()) {
    throw Error(
        fmt::format("profile '{}'", name_or_path), fmt::format("is not one of the {}", folder),
        did_you_mean(name_or_path, names,
                     fmt::format("choose one of {}, or give a path", fmt::join(names, ", "))));
  }
  return profile_folder(folder) / (name_or_path + ".toml");
}

/// { duration_ms = 8.0, provenance = "assumed" }
KnownDuration require_duration(TomlReader& table, std::string_view key, std::string_view meaning) {
  constexpr std::array words{Word<Provenance>{"measured", Provenance::measured},
                             Word<Provenance>{"assumed", Provenance::assumed}};
  TomlReader inner = table.table(required(key), meaning);
  KnownDuration duration;
  double duration_ms = 0.0;
  inner.read(required("duration_ms"), duration_ms, 0.0, 1000.0, "Milliseconds.");
  duration.duration_s = 1e-3 * duration_ms;
  inner.read(required("provenance"), duration.provenance, words,
             "Whether the duration was measured or is assumed.");
  inner.reject_unknown_keys();
  return duration;
}

void read_headset(TomlReader& table, DisplayProfile& display) {
  table.read(required("horizontal_fov_deg"), display.horizontal_fov_deg, 1.0, 179.0,
             "A headset's horizontal field of view of one eye, in degrees. Required of a headset.");
  table.read(required("vertical_fov_deg"), display.vertical_fov_deg, 1.0, 179.0,
             "A headset's vertical field of view, in degrees. Required of a headset.");
  if (display.width_px % 2 != 0) {
    table.fail(table.source("width_px"), "two views side by side need an even width",
               "give the width of both together");
  }
  TomlReader lens = table.table(
      "lens", "A headset's lens, of the left eye; the right eye's is its mirror image.");
  if (table.has("lens")) {
    lens.require("k1");
    lens.require("k2");
    display.lens = read_lens(lens, {});
    lens.reject_unknown_keys();
  }
}

double fov_deg(double size_m, double distance_m) {
  return degrees(2.0 * std::atan2(0.5 * size_m, distance_m));
}

void read_monitor(TomlReader& table, DisplayProfile& display) {
  constexpr double largest_stretch = 1.25;
  table.read(required("width_m"), display.width_m, 0.01, 20.0,
             "Width of a monitor's picture in metres. Required of a monitor.");
  table.read(required("height_m"), display.height_m, 0.01, 20.0,
             "Height of a monitor's picture in metres. Required of a monitor.");
  table.read(required("viewing_distance_m"), display.viewing_distance_m, 0.05, 50.0,
             "Distance from the eyes to a monitor in metres. Required of a monitor.");
  const double stretch =
      (display.width_m / display.width_px) / (display.height_m / display.height_px);
  if (std::max(stretch, 1.0 / stretch) > largest_stretch) {
    table.fail(table.source("width_m"), "such a size has no square pixels",
               "give the size of the picture, without the frame");
  }
  display.horizontal_fov_deg = fov_deg(display.width_m, display.viewing_distance_m);
  display.vertical_fov_deg = fov_deg(display.height_m, display.viewing_distance_m);
}

MeasuredDisplay read_measured(TomlReader table) {
  MeasuredDisplay measured;
  measured.date = table.require_text("date", "The date of the measurement.");
  table.read("instrument", measured.instrument, "The instrument of the measurement.");
  table.read("white_cd_m2", measured.white_cd_m2, 0.001, 1e5,
             "Luminance of white in the centre, in cd/m².");
  table.read("black_cd_m2", measured.black_cd_m2, 0.0, 1e5, "Luminance of black, in cd/m².");
  table.read("gamma", measured.gamma, 0.1, 10.0, "The exponent from pixel values to luminance.");
  table.read("refresh_rate_hz", measured.refresh_rate_hz, 1.0, 1000.0, "Refreshes per second.");
  table.reject_unknown_keys();
  return measured;
}

constexpr std::array corners{
    Word<WindowCorner>{"top left", WindowCorner::top_left},
    Word<WindowCorner>{"top right", WindowCorner::top_right},
    Word<WindowCorner>{"bottom left", WindowCorner::bottom_left},
    Word<WindowCorner>{"bottom right", WindowCorner::bottom_right},
};

TimingPatch read_timing_patch(TomlReader table) {
  TimingPatch patch;
  table.read(required("corner"), patch.corner, corners, "The corner of the window.");
  table.read("size_px", patch.size_px, 1, 4096, "Its side in pixels.");
  table.reject_unknown_keys();
  return patch;
}

DisplayProfile display_from(TomlReader table) {
  constexpr std::array words{Word<DisplayKind>{"headset", DisplayKind::headset},
                             Word<DisplayKind>{"monitor", DisplayKind::monitor},
                             Word<DisplayKind>{"openxr", DisplayKind::openxr}};
  DisplayProfile display;
  display.title = table.require_text("title", "The display's name, for people.");
  table.read(required("kind"), display.kind, words,
             "headset: two views side by side in a window, each through a lens; monitor: one flat "
             "view; openxr: a headset by OpenXR, whose runtime gives the rest, so that no other "
             "key is allowed.");
  if (display.kind == DisplayKind::openxr) {
    table.reject_unknown_keys();
    return display;
  }
  table.read(required("width_px"), display.width_px, 16, 65536,
             "Width of the whole display in pixels, in a headset of both views "
             "together. Required of a headset and a monitor.");
  table.read(required("height_px"), display.height_px, 16, 65536,
             "Height of the whole display in pixels. Required of a headset and a monitor.");
  table.read(required("refresh_rate_hz"), display.refresh_rate_hz, 1.0, 1000.0,
             "Refreshes per second. Required of a headset and a monitor.");
  if (display.kind == DisplayKind::headset) {
    read_headset(table, display);
  } else {
    read_monitor(table, display);
  }
  display.scan_out = require_duration(table, "scan_out",
                                      "The time from a frame's presentation until all of "
                                      "it is lit. Required of a headset and a monitor.");
  table.read_table("measured", display.measured, read_measured,
                   "Measurements of the display with instruments.");
  table.read_table("timing_patch", display.timing_patch, read_timing_patch,
                   "A square in a corner of the window that is white while a "
                   "trial is shown and black otherwise, for a photodiode.");
  table.reject_unknown_keys();
  return display;
}

void read_open_gaze(TomlReader table, OpenGazeAddress& address) {
  int port = address.port;
  table.read("host", address.host, "The computer.");
  if (address.host.empty()) {
    table.fail(table.source("host"), "open_gaze.host is empty", "name a computer, or leave it out");
  }
  table.read("port", port, 1, 65535, "Its TCP port.");
  address.port = static_cast<std::uint16_t>(port);
  table.reject_unknown_keys();
}

void read_simulated(TomlReader table, SimulatedTrackerSettings& settings) {
  table.read("precision_deg", settings.precision_deg, 0.0, 10.0,
             "Standard deviation of its noise along each axis, in degrees.");
  table.read("bias_right_deg", settings.bias_right_deg, -30.0, 30.0,
             "Constant error of the azimuth, in degrees.");
  table.read("bias_up_deg", settings.bias_up_deg, -30.0, 30.0,
             "Constant error of the elevation, in degrees.");
  table.read("data_loss", settings.data_loss, 0.0, 1.0, "Share of invalid samples.");
  table.reject_unknown_keys();
}

constexpr std::array sources{
    Word<TrackerSource>{"hid", TrackerSource::hid},
    Word<TrackerSource>{"open-gaze", TrackerSource::open_gaze},
    Word<TrackerSource>{"openxr", TrackerSource::openxr},
    Word<TrackerSource>{"pointer", TrackerSource::pointer},
    Word<TrackerSource>{"recorded", TrackerSource::recorded},
    Word<TrackerSource>{"simulated", TrackerSource::simulated},
};

TrackerProfile tracker_from(TomlReader table) {
  TrackerProfile tracker;
  tracker.title = table.require_text("title", "The tracker's name, for people.");
  table.read(required("source"), tracker.source, sources,
             "hid: the HID standard for eye trackers; open-gaze: the Open Gaze API; openxr: "
             "a headset by OpenXR; pointer: the mouse's pointer; recorded: the file of a "
             "recording; simulated: a simulated tracker.");
  table.read(required("rate_hz"), tracker.rate_hz, 1.0, 10000.0, "Samples per second.");
  tracker.exposure =
      require_duration(table, "exposure", "Exposure time of a sample's picture of the eye.");
  tracker.transfer =
      require_duration(table, "transfer", "Transfer time of a picture from the camera.");
  tracker.processing =
      require_duration(table, "processing", "Processing time from a picture to its gaze.");
  if (tracker.source == TrackerSource::open_gaze) {
    read_open_gaze(table.table("open_gaze", "Address of the server of an open-gaze source."),
                   tracker.open_gaze);
  }
  if (tracker.source == TrackerSource::recorded) {
    tracker.recording = table.require_text("recording",
                                           "The file that a recorded source replays, in the "
                                           "profile's folder. Required of such a source.");
  }
  if (tracker.source == TrackerSource::simulated) {
    read_simulated(
        table.table(
            "simulated",
            "Settings of a simulated source. Its latency follows from the durations above."),
        tracker.simulated);
  }
  tracker.simulated.rate_hz = tracker.rate_hz;
  tracker.simulated.latency_s = seconds(shortest_delay(tracker));
  table.reject_unknown_keys();
  return tracker;
}

/// Reads the profile with `from`.
template <typename From>
auto read_profile(std::string_view folder, const std::string& name_or_path, const From& from) {
  const fs::path file = profile_file(folder, name_or_path);
  std::string text = read_toml_file(file);
  const toml::table content = parse_toml(
      file.string(), text, fmt::format("see those in {}", profile_folder(folder).string()));
  auto profile = from(TomlReader(file.string(), content, ""));
  profile.name = file.stem().string();
  profile.toml = std::move(text);
  return profile;
}

/// The recording named by a profile, which is untrusted.
fs::path recording_beside(const fs::path& profile, const fs::path& recording) {
  try {
    return confined_path(fs::absolute(profile).parent_path(), recording);
  } catch (const std::runtime_error& reason) {
    throw Error(profile.string(),
                fmt::format("its recording '{}' is {}", recording.string(), reason.what()),
                "put a copy into the folder of the profile");
  }
}

/// Reads a profile that was kept with `from`.
template <typename From>
auto profile_in(const std::string& toml, const std::string& where, const From& from,
                TomlKeys* keys) {
  const toml::table content =
      parse_toml(where, toml, "put a copy of the study in its place by foveola study restore");
  auto profile = from(TomlReader(where, content, "", keys));
  profile.toml = toml;
  return profile;
}

}  // namespace

bool is_profile_path(const std::string& name_or_path) {
  return name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
}

const char* name_of(WindowCorner corner) { return word_for(corners, corner); }

const char* name_of(TrackerSource source) { return word_for(sources, source); }

Nanoseconds shortest_delay(const TrackerProfile& profile) {
  return nanoseconds_from_seconds(0.5 * profile.exposure.duration_s + profile.transfer.duration_s +
                                  profile.processing.duration_s);
}

DisplayProfile read_display_profile(const std::string& name_or_path) {
  return read_profile(displays, name_or_path, display_from);
}

TrackerProfile read_tracker_profile(const std::string& name_or_path) {
  TrackerProfile tracker = read_profile(trackers, name_or_path, tracker_from);
  if (tracker.source == TrackerSource::recorded) {
    tracker.recording = recording_beside(profile_file(trackers, name_or_path), tracker.recording);
  }
  return tracker;
}

DisplayProfile display_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys) {
  return profile_in(toml, where, display_from, keys);
}

TrackerProfile tracker_profile_in(const std::string& toml, const std::string& where,
                                  TomlKeys* keys) {
  return profile_in(toml, where, tracker_from, keys);
}

std::vector<std::string> tracker_profile_names() { return toml_names_in(profile_folder(trackers)); }

RadialLens read_lens(TomlReader& table, RadialLens lens) {
  constexpr double strongest = 100.0;
  double k1 = lens.k1;
  double k2 = lens.k2;
  table.read("axis", lens.axis, 0.0, 1.0,
             "Where the lens's axis meets the view, from the left and the top, 0 to 1.");
  table.read("k1", k1, -strongest, strongest,
             "Distortion coefficient of the squared distance from the axis.");
  table.read("k2", k2, -strongest, strongest, "Distortion coefficient of its fourth power.");
  lens.k1 = static_cast<float>(k1);
  lens.k2 = static_cast<float>(k2);
  return lens;
}

Screen screen_of(const DisplayProfile& display) {
  constexpr double headset_distance_m = 1.0;
  Screen screen{.width_m = display.width_m,
                .height_m = display.height_m,
                .horizontal_fov_deg = display.horizontal_fov_deg,
                .vertical_fov_deg = display.vertical_fov_deg};
  if (display.kind != DisplayKind::monitor) {
    screen.width_m = 2.0 * headset_distance_m * std::tan(radians(0.5 * display.horizontal_fov_deg));
    screen.height_m = 2.0 * headset_distance_m * std::tan(radians(0.5 * display.vertical_fov_deg));
  }
  return screen;
}

}  // namespace foveola
