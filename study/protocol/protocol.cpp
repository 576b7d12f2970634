#include "study/protocol/protocol.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/confined_path.h"
#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/toml_reader.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

constexpr int largest_film_side = 65536;
constexpr int largest_view_side = 8192;
constexpr int most_samples = std::numeric_limits<int>::max();

std::vector<SceneEntry> read_scenes(TomlReader& reader) {
  std::vector<SceneEntry> scenes;
  for (const TomlReader::Text& scene : reader.require_texts("scenes")) {
    scenes.push_back({.name = scene.value,
                      .line = static_cast<int>(scene.source.begin.line),
                      .column = static_cast<int>(scene.source.begin.column)});
  }
  return scenes;
}

/// Throws Error for a file out of the folder, for one that is no image of weights, and for one that
/// somebody writes at this moment.
MethodFile read_method_file(const std::string& method, const std::string& file,
                            const fs::path& folder) {
  fs::path path;
  try {
    path = confined_path(folder, file);
  } catch (const std::runtime_error& reason) {
    throw Error(fmt::format("method '{}'", method),
                fmt::format("its file '{}' is {}", file, reason.what()),
                "put a copy into the folder of the protocol");
  }
  const std::string digest = sha256_of_file(path);
  auto weights = std::make_shared<const WeightImage>(read_weights(path));
  if (sha256_of_file(path) != digest) {
    throw Error(path.string(), "changed while it was read", "try again when it is finished");
  }
  return {.method = method, .file = file, .sha256 = digest, .weights = std::move(weights)};
}

const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const MethodFile& known) {
    return known.method == method && known.file == file;
  });
  return found != files.end() ? &*found : nullptr;
}

/// Throws Error for what no session could use.
void require_usable(const std::string& method, const fs::path& folder,
                    std::vector<MethodFile>& files) {
  if (follows_pointer(method)) {
    throw Error(fmt::format("method '{}'", method),
                "follows a pointer, and in this version nobody can point in a session",
                "hold it in place with azimuth= and elevation=, or choose another method");
  }
  make_view_sampler(method, [&](const std::string& file) {
    if (find_method_file(files, method, file) == nullptr) {
      files.push_back(read_method_file(method, file, folder));
    }
    return *find_method_file(files, method, file)->weights;
  });
}

fs::path folder_of(const Protocol& protocol) { return fs::absolute(protocol.path).parent_path(); }

void read_methods(TomlReader& reader, Protocol& protocol) {
  for (const TomlReader::Text& method : reader.require_texts("methods")) {
    try {
      require_usable(method.value, folder_of(protocol), protocol.method_files);
    } catch (const Error& error) {
      reader.fail(method.source, error.what(), "see foveola render --help");
    }
    protocol.methods.push_back(method.value);
  }
}

MachineModel read_machine(TomlReader reader) {
  MachineModel machine;
  reader.read("samples_per_second", machine.samples_per_second, 1.0, 1e12);
  reader.read("frame_rate_hz", machine.frame_rate_hz, 1.0, 1000.0);
  reader.reject_unknown_keys();
  return machine;
}

/// The profile that the table names, by `read`; empty if it names none.
template <typename Profile>
std::optional<Profile> read_profile(TomlReader& reader, const fs::path& folder,
                                    Profile (*read)(const std::string&)) {
  std::string name;
  reader.read("profile", name);
  if (!reader.has("profile")) {
    return std::nullopt;
  }
  try {
    return read(is_profile_path(name) ? confined_path(folder, name).string() : name);
  } catch (const std::runtime_error& reason) {
    reader.fail(reader.source("profile"), fmt::format("profile '{}': {}", name, reason.what()),
                "name one that comes with Foveola, or a file in the folder of the protocol");
  }
}

/// Of the eye that is shown, over the left eye's of the profile.
RadialLens read_eyes_lens(TomlReader reader, const RadialLens& profile) {
  const RadialLens lens = read_lens(reader, profile);
  std::string eye = "left";
  reader.read("eye", eye);
  if (eye != "left" && eye != "right") {
    reader.fail(reader.source("eye"), fmt::format("there is no eye '{}'", eye),
                "choose left, whose lens this is, or right, before which it is mirrored");
  }
  reader.reject_unknown_keys();
  return eye == "right" ? mirrored(lens) : lens;
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

/// Throws Error through `reader`. The view's size must have been read.
void read_fields_of_view(TomlReader& reader, DisplaySettings& display) {
  constexpr double narrowest_deg = 1.0;
  constexpr double widest_deg = 170.0;
  if (display.profile && !reader.has("fov_deg")) {
    display.horizontal_fov_deg = display.profile->horizontal_fov_deg;
    display.vertical_fov_deg = display.profile->vertical_fov_deg;
    return;
  }
  if (reader.is_array("fov_deg")) {
    Vec2 both(0.0F);
    reader.read("fov_deg", both, narrowest_deg, widest_deg);
    display.horizontal_fov_deg = both.x;
    display.vertical_fov_deg = both.y;
    return;
  }
  reader.read("fov_deg", display.horizontal_fov_deg, narrowest_deg, widest_deg);
  display.vertical_fov_deg = display.horizontal_fov_deg;
  if (display.view_width != display.view_height) {
    const double aspect = static_cast<double>(display.view_height) / display.view_width;
    const double half_width = std::tan(0.5 * radians(display.horizontal_fov_deg));
    display.vertical_fov_deg = degrees(2.0 * std::atan(half_width * aspect));
  }
}

DisplaySettings read_display(TomlReader reader, const fs::path& folder) {
  DisplaySettings display;
  display.profile = read_profile(reader, folder, read_display_profile);
  reader.read("view_width", display.view_width, 8, largest_view_side);
  reader.read("view_height", display.view_height, 8, largest_view_side);
  read_fields_of_view(reader, display);
  reader.read("fill_unsampled", display.fill_unsampled);
  display.lens =
      read_eyes_lens(reader.table("lens"),
                     display.profile ? display.profile->lens.value_or(RadialLens{}) : RadialLens{});
  require_view(reader, display);
  reader.reject_unknown_keys();
  return display;
}

FilmSettings read_film(TomlReader reader) {
  FilmSettings film;
  reader.read("width", film.width, 8, largest_film_side);
  reader.read("height", film.height, 4, largest_film_side);
  reader.read("spare_done_contrast", film.spare_done_contrast, 0.0, 0.99);
  reader.read("max_depth", film.max_depth, 1, 1000);
  reader.reject_unknown_keys();
  return film;
}

ValidationSettings read_validation(TomlReader reader) {
  constexpr double largest_deg = 45.0;
  ValidationSettings validation;
  reader.read("points", validation.points, 5, 9);
  if (validation.points != 5 && validation.points != 9) {
    reader.fail(reader.source("points"), fmt::format("there is no grid of {}", validation.points),
                "choose 5 or 9 points");
  }
  reader.read("max_accuracy_deg", validation.gate.max_accuracy_deg, 0.0, largest_deg);
  reader.read("max_precision_deg", validation.gate.max_precision_deg, 0.0, largest_deg);
  reader.read("max_data_loss", validation.gate.max_data_loss, 0.0, 1.0);
  reader.read("correct", validation.correct);
  reader.read("attempts", validation.attempts, 1, 100);
  reader.reject_unknown_keys();
  return validation;
}

TrackerSettings read_tracker(TomlReader reader, const fs::path& folder) {
  TrackerSettings tracker;
  tracker.profile = read_profile(reader, folder, read_tracker_profile);
  if (tracker.profile) {
    tracker.simulated = tracker.profile->simulated;
  }
  reader.read("rate_hz", tracker.simulated.rate_hz, 1.0, 10000.0);
  reader.read("latency_s", tracker.simulated.latency_s, 0.0, 1.0);
  reader.read("precision_deg", tracker.simulated.precision_deg, 0.0, 10.0);
  const TomlReader validation = reader.table("validation");
  if (reader.has("validation")) {
    tracker.validation = read_validation(validation);
  }
  reader.reject_unknown_keys();
  return tracker;
}

Timing read_timing(TomlReader reader) {
  Timing timing;
  reader.read("mark_timeout_s", timing.mark_timeout_s, 0.1, 3600.0);
  reader.read("rating_s", timing.rating_s, 0.1, 3600.0);
  reader.reject_unknown_keys();
  return timing;
}

ReferenceQuality read_reference(TomlReader reader) {
  ReferenceQuality reference;
  reader.read("samples_per_pixel", reference.samples_per_pixel, 1, 1 << 20);
  reader.read("samples_per_object", reference.samples_per_object, 0, most_samples);
  reader.reject_unknown_keys();
  return reference;
}

std::vector<Question> read_background(std::vector<TomlReader> readers) {
  std::vector<Question> questions;
  for (TomlReader& reader : readers) {
    Question question{.id = reader.require_text("id"), .text = reader.require_text("text")};
    reader.read("minimum", question.minimum, -1'000'000, 1'000'000);
    reader.read("maximum", question.maximum, question.minimum + 1, 1'000'001);
    reader.reject_unknown_keys();
    if (std::any_of(questions.begin(), questions.end(),
                    [&](const Question& other) { return other.id == question.id; })) {
      reader.fail(reader.source(), fmt::format("the question '{}' is asked twice", question.id),
                  "give each its own id");
    }
    questions.push_back(std::move(question));
  }
  return questions;
}

std::vector<std::string> known_protocols(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path find_protocol(const std::string& name_or_path) {
  if (fs::exists(name_or_path)) {
    return name_or_path;
  }
  const fs::path folder = resource_folder() / "protocols";
  const fs::path named = folder / (name_or_path + ".toml");
  if (name_or_path.find('/') == std::string::npos && fs::is_regular_file(named)) {
    return named;
  }
  throw Error(
      name_or_path, "there is no such protocol",
      fmt::format("give a .toml file or one of {}", fmt::join(known_protocols(folder), ", ")));
}

Protocol load_protocol(const fs::path& path) {
  Protocol protocol;
  protocol.path = path;
  protocol.text = read_file(path);
  protocol.sha256 = sha256(std::string_view(protocol.text));
  const toml::table table =
      parse_toml(path.string(), protocol.text, "see protocols/demo.toml for an example");
  TomlReader reader(path.string(), table, "");
  protocol.name = reader.require_text("name");
  protocol.title = reader.require_text("title");
  protocol.scenes = read_scenes(reader);
  read_methods(reader, protocol);
  protocol.machine = read_machine(reader.table("machine"));
  protocol.display = read_display(reader.table("display"), folder_of(protocol));
  protocol.film = read_film(reader.table("film"));
  protocol.tracker = read_tracker(reader.table("tracker"), folder_of(protocol));
  protocol.timing = read_timing(reader.table("timing"));
  protocol.reference = read_reference(reader.table("reference"));
  protocol.background = read_background(reader.tables("background"));
  reader.reject_unknown_keys();
  return protocol;
}

std::vector<NamedProfile> named_profiles(const Protocol& protocol) {
  std::vector<NamedProfile> profiles;
  if (const auto& display = protocol.display.profile) {
    profiles.push_back({.device = "display", .name = display->name, .toml = display->toml});
  }
  if (const auto& tracker = protocol.tracker.profile) {
    profiles.push_back({.device = "tracker", .name = tracker->name, .toml = tracker->toml});
  }
  return profiles;
}

std::unique_ptr<ViewSampler> make_sampler(const Protocol& protocol, const std::string& method) {
  return make_view_sampler(method, [&](const std::string& file) {
    const MethodFile* known = find_method_file(protocol.method_files, method, file);
    assert(known != nullptr);
    return *known->weights;
  });
}

std::vector<SceneSource> find_scenes(const Protocol& protocol, const SceneFinder& find_scene) {
  std::vector<SceneSource> sources;
  for (const SceneEntry& entry : protocol.scenes) {
    const std::string place =
        fmt::format("{}:{}:{}", protocol.path.string(), entry.line, entry.column);
    try {
      sources.push_back(find_scene(entry.name));
    } catch (const Error& error) {
      throw Error(place, error.what());
    }
    if (sources.back().objects.empty()) {
      throw Error(place, fmt::format("the scene '{}' names no objects to choose", entry.name),
                  "give it a descriptor with [[object]] entries");
    }
    if (!sources.back().camera_position) {
      throw Error(place, fmt::format("the scene '{}' has no viewpoint", entry.name),
                  "give it a descriptor with a camera position");
    }
  }
  return sources;
}

}  // namespace foveola::study
