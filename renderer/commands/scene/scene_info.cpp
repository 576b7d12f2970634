#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/base/clock.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/command_line/common_options.h"
#include "renderer/commands/commands.h"
#include "renderer/commands/look_options.h"
#include "renderer/progressive/picture.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/prepare/made_up_names.h"
#include "renderer/scene/scene_facts.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {
namespace {

/// Facts of a loaded scene, with the time and memory that it takes.
struct LoadedFacts {
  SceneSource source;
  std::string sha256;
  std::vector<std::string> warnings;
  double load_s = 0.0;
  std::size_t tracing_bytes = 0;  ///< see RayScene::memory_bytes
  SceneFacts facts;
  std::vector<PunctualLight> lights;
  std::vector<CameraView> cameras;
  std::vector<std::string> clips;
  DVec3 origin;  ///< see Scene::origin
  DVec3 lower;   ///< lower corner of its bounds in metres, in the file's world, as for --camera
  DVec3 upper;
};

LoadedFacts load_facts(const SceneSource& source, const std::stop_token& stop) {
  const StuckLoadExit exit(stop);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const Scene scene = load_watched(stop, [&] { return load_scene(source); });
  const double load_s = seconds(clock.now() - start);
  const SceneFacts facts = facts_of(scene);
  // The acceleration structure is built only to measure its memory.
  const std::size_t tracing_bytes = RayScene(scene, Workers()).memory_bytes();
  return {.source = source,
          .sha256 = scene.sha256,
          .warnings = scene.warnings,
          .load_s = load_s,
          .tracing_bytes = tracing_bytes,
          .facts = facts,
          .lights = scene.lights,
          .cameras = scene.cameras,
          .clips = scene.clips,
          .origin = scene.origin,
          .lower = DVec3(facts.bounds.lower) + scene.origin,
          .upper = DVec3(facts.bounds.upper) + scene.origin};
}

nlohmann::json json_of(const DVec3& v) { return {v.x, v.y, v.z}; }

/// A kind of light without geometry, and its intensity's unit.
struct LightKind {
  PunctualLight::Kind kind;
  const char* name;
  const char* unit;
};

constexpr std::array<LightKind, 3> light_kinds = {
    {{PunctualLight::Kind::point, "point", "W/sr"},
     {PunctualLight::Kind::spot, "spot", "W/sr"},
     {PunctualLight::Kind::directional, "directional", "W/m^2"}}};

std::size_t count_of(PunctualLight::Kind kind, const std::vector<PunctualLight>& lights) {
  return static_cast<std::size_t>(std::ranges::count(lights, kind, &PunctualLight::kind));
}

nlohmann::ordered_json json_kinds(const std::vector<PunctualLight>& lights) {
  nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
  for (const LightKind& kind : light_kinds) {
    if (const std::size_t count = count_of(kind.kind, lights); count > 0) {
      kinds.push_back({{"kind", kind.name}, {"count", count}, {"unit", kind.unit}});
    }
  }
  return kinds;
}

/// " (2 point in W/sr, 1 directional in W/m^2)"; empty without lights.
std::string text_kinds(const std::vector<PunctualLight>& lights) {
  std::vector<std::string> kinds;
  for (const LightKind& kind : light_kinds) {
    if (const std::size_t count = count_of(kind.kind, lights); count > 0) {
      kinds.push_back(fmt::format("{} {} in {}", count, kind.name, kind.unit));
    }
  }
  return kinds.empty() ? "" : fmt::format(" ({})", fmt::join(kinds, ", "));
}

nlohmann::ordered_json json_cameras(const LoadedFacts& loaded) {
  nlohmann::ordered_json cameras = nlohmann::ordered_json::array();
  const std::vector<std::string> names = camera_names(loaded.cameras);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const CameraView& view = loaded.cameras[i];
    nlohmann::ordered_json camera = {
        {"name", names[i]},
        {"position", json_of(DVec3(view.position) + loaded.origin)},
        {"head_deg", {degrees(view.heading.azimuth_rad), degrees(view.heading.elevation_rad)}},
        {"roll_deg", degrees(view.roll_rad)}};
    camera["vertical_fov_deg"] = view.vertical_fov_rad
                                     ? nlohmann::ordered_json(degrees(*view.vertical_fov_rad))
                                     : nlohmann::ordered_json(nullptr);
    camera["aspect_ratio"] = view.aspect_ratio ? nlohmann::ordered_json(*view.aspect_ratio)
                                               : nlohmann::ordered_json(nullptr);
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

/// In degrees, rounded to hundredths, and never -0.
double shown_deg(double angle_rad) {
  constexpr double steps = 100.0;
  return std::round(steps * degrees(angle_rad)) / steps + 0.0;
}

/// A line per camera: its name for --camera, its place, heading and field of view.
void print_cameras(const LoadedFacts& loaded) {
  const std::vector<std::string> names = camera_names(loaded.cameras);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const CameraView& view = loaded.cameras[i];
    const DVec3 place = DVec3(view.position) + loaded.origin;
    const FieldOfView fov = picture_of(view, {}).field_of_view;
    print_text(
        "camera     '{}' at {:.6g},{:.6g},{:.6g} towards {:g},{:g}, {:.4g} x {:.4g} degrees\n",
        names[i], place.x, place.y, place.z, shown_deg(view.heading.azimuth_rad),
        shown_deg(view.heading.elevation_rad), fov.horizontal_deg, fov.vertical_deg);
  }
}

/// Paths may hold invalid Unicode.
void print_json(const LoadedFacts& loaded) {
  const SceneFacts& facts = loaded.facts;
  const nlohmann::ordered_json json = {{"name", loaded.source.name},
                                       {"title", loaded.source.title},
                                       {"file", loaded.source.file.string()},
                                       {"sha256", loaded.sha256},
                                       {"metres_per_unit", loaded.source.metres_per_unit},
                                       {"load_seconds", loaded.load_s},
                                       {"objects", facts.objects},
                                       {"instances", facts.instances},
                                       {"triangles", facts.triangles},
                                       {"stored_triangles", facts.stored_triangles},
                                       {"emissive_triangles", facts.emissive_triangles},
                                       {"lights", facts.lights},
                                       {"light_kinds", json_kinds(loaded.lights)},
                                       {"cameras", json_cameras(loaded)},
                                       {"clips", loaded.clips},
                                       {"materials", facts.materials},
                                       {"textures", facts.textures},
                                       {"geometry_bytes", facts.geometry_bytes},
                                       {"tracing_bytes", loaded.tracing_bytes},
                                       {"texture_bytes", facts.texture_bytes},
                                       {"environment_bytes", facts.environment_bytes},
                                       {"bounds", {json_of(loaded.lower), json_of(loaded.upper)}},
                                       {"features", facts.features},
                                       {"absent_features", facts.absent_features},
                                       {"warnings", loaded.warnings}};
  constexpr int indentation = 2;
  print_text("{}\n", json.dump(indentation, ' ', false, nlohmann::json::error_handler_t::replace));
}

double mib(std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

void print_memory(const SceneFacts& facts, std::size_t tracing_bytes) {
  const auto bytes = static_cast<double>(facts.geometry_bytes + tracing_bytes);
  const double bytes_a_triangle =
      facts.stored_triangles == 0 ? 0.0 : bytes / static_cast<double>(facts.stored_triangles);
  print_text(
      "memory     geometry {:.1f} MiB and Embree's hierarchy {:.1f} MiB ({:.0f} bytes per "
      "triangle), textures {:.1f} MiB\n",
      mib(facts.geometry_bytes), mib(tracing_bytes), bytes_a_triangle,
      mib(facts.texture_bytes + facts.environment_bytes));
}

/// Prints a line, unless the list is empty.
void print_list(const char* label, const std::vector<std::string>& items) {
  if (!items.empty()) {
    print_text("{}{}\n", label, fmt::join(items, ", "));
  }
}

void print_words(const LoadedFacts& loaded) {
  const SceneFacts& facts = loaded.facts;
  print_text("{}\n", printable(loaded.source.title));
  print_text("file       {}\nsha256     {}\n", printable(loaded.source.file.string()),
             loaded.sha256);
  print_text("loaded in  {}\n", human_duration(loaded.load_s));
  print_text("triangles  {} ({} in memory) in {} objects, {} of them instances\n", facts.triangles,
             facts.stored_triangles, facts.objects, facts.instances);
  print_text("materials  {}, textures {}\n", facts.materials, facts.textures);
  print_text("light      {} emissive triangles, {} lights without geometry{}\n",
             facts.emissive_triangles, facts.lights, text_kinds(loaded.lights));
  print_cameras(loaded);
  for (const std::string& clip : loaded.clips) {
    print_text("clip       '{}'\n", printable(clip));
  }
  print_text("bounds     ({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g}) m\n", loaded.lower.x,
             loaded.lower.y, loaded.lower.z, loaded.upper.x, loaded.upper.y, loaded.upper.z);
  if (loaded.source.metres_per_unit != 1.0) {
    print_text("scale      the file's unit is {:g} m\n", loaded.source.metres_per_unit);
  }
  print_memory(facts, loaded.tracing_bytes);
  print_list("has        ", facts.features);
  print_list("has no     ", facts.absent_features);
  for (const std::string& warning : loaded.warnings) {
    print_text("warning    {}\n", printable(warning));
  }
}

}  // namespace

void add_scene_info(CLI::App& scene, const SceneFinder& find_scene, const std::stop_token& stop) {
  const auto name = std::make_shared<std::string>();
  const auto look = std::make_shared<LookArguments>();
  const auto as_json = std::make_shared<bool>(false);
  CLI::App* command = scene.add_subcommand("info", "Print a scene's content and memory");
  add_scene_option(*command, *name);
  add_light_options(*command, *look);
  command->add_flag("--json", *as_json, "Print it as JSON");
  command->footer("Example: foveola scene info arcade");
  command->callback([name, look, as_json, find_scene, stop] {
    const LoadedFacts loaded = load_facts(lit_scene(*name, *look, find_scene), stop);
    *as_json ? print_json(loaded) : print_words(loaded);
  });
}

}  // namespace foveola
