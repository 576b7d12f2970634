#include "renderer/progressive/loaded_scene.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/progressive/picture.h"
#include "renderer/progressive/standpoint.h"
#include "renderer/progressive/surroundings.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/prepare/far_geometry.h"
#include "renderer/scene/prepare/made_up_names.h"
#include "renderer/scene/scene_facts.h"

namespace foveola {
namespace {

/// A material that any renderer supports, for comparisons.
void make_diffuse(Material& material) {
  material.metallic = 0.0F;
  material.specular = 0.0F;
  material.transmission = 0.0F;
  material.clearcoat = 0.0F;
  material.sheen_color = Rgb(0.0F);
  material.normal_texture = {};
}

Scene as_chosen(Scene scene, bool diffuse, bool has_studio_light) {
  if (diffuse) {
    std::ranges::for_each(scene.materials, make_diffuse);
  }
  if (has_studio_light) {
    add_studio_light(scene);
  }
  return scene;
}

/// The default camera. Adds notes about it.
CameraView camera_at_standpoint(const Scene& scene, const RayScene& rays,
                                const SceneChoices& choices, std::vector<std::string>& warnings) {
  const FieldOfView framed_for = choices.framed_for.value_or(picture_of({}, {}).field_of_view);
  const Standpoint standpoint = choose_standpoint(scene, rays, framed_for);
  for (std::string& note : notes_on_standpoint(scene, rays, standpoint, framed_for)) {
    warnings.push_back(std::move(note));
  }
  CameraView view;
  view.position = standpoint.position;
  view.heading = standpoint.heading;
  return view;
}

/// The file's camera of this name, see camera_names. Throws UsageError.
const CameraView& camera_named(const Scene& scene, const std::string& name) {
  const std::vector<std::string> names = camera_names(scene.cameras);
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw UsageError("--camera", fmt::format("the file has no camera '{}'", name),
                     names.empty() ? "it has none at all: give a place, X,Y,Z"
                                   : fmt::format("it has '{}'; or give a place, X,Y,Z",
                                                 fmt::join(names, "', '")));
  }
  return scene.cameras[static_cast<std::size_t>(found - names.begin())];
}

/// Throws Error.
void require_traceable(const Vec3& camera) {
  if (!is_traceable(camera)) {
    throw Error("the camera",
                fmt::format("{:g},{:g},{:g} is not within {:.2g} m of the scene's origin", camera.x,
                            camera.y, camera.z, max_coordinate_m),
                "give a nearer place: --camera X,Y,Z");
  }
}

CameraView choose_camera(const SceneSource& source, const Scene& scene, const RayScene& rays,
                         const SceneChoices& choices, std::vector<std::string>& warnings) {
  CameraView view;
  if (!choices.camera_name.empty()) {
    view = camera_named(scene, choices.camera_name);
  } else if (source.camera_position) {
    view.position = scene.from_file(*source.camera_position);
    view.heading = source.heading;
    view.roll_rad = source.camera_roll_rad;
    view.vertical_fov_rad = source.camera_vertical_fov_rad;
    view.aspect_ratio = source.camera_aspect_ratio;
  } else if (!scene.cameras.empty()) {
    view = scene.cameras.front();
  } else if (!choices.camera) {
    view = camera_at_standpoint(scene, rays, choices, warnings);
  }
  if (choices.camera) {
    view.position = scene.from_file(*choices.camera);
  }
  if (choices.head) {
    view.heading = *choices.head;
    view.roll_rad = 0.0;
  }
  require_traceable(view.position);
  return view;
}

/// The result of `step` and its duration.
template <typename Step>
auto timed(const Step& step) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  auto result = step();
  return std::pair(std::move(result), seconds(clock.now() - start));
}

PathTracer build(const Scene& scene, const Workers& workers, KeptForReload* kept,
                 double& elapsed_s) {
  auto [tracer, took_s] = timed([&] {
    const bool keeps_hierarchies = kept != nullptr && kept->parts.places_instances;
    return PathTracer(scene, workers, {}, keeps_hierarchies ? &kept->hierarchies : nullptr);
  });
  elapsed_s = took_s;
  return std::move(tracer);
}

namespace fs = std::filesystem;

/// All files of the scene, including those that may be read the next time, like a descriptor beside
/// its file.
std::set<fs::path> files_of(const LoadedScene& loaded) {
  std::set<fs::path> files = loaded.scene.files;
  files.insert(loaded.source.file);
  files.insert(fs::path(loaded.source.file).replace_extension(".toml"));
  if (!loaded.source.descriptor.empty()) {
    files.insert(loaded.source.descriptor);
  }
  return files;
}

}  // namespace

LoadedScene::LoadedScene(const SceneSource& scene_source, const Workers& workers,
                         const SceneChoices& choices, KeptForReload* kept)
    : LoadedScene(scene_source, timed([&] {
                    return load_scene(scene_source, kept != nullptr ? &kept->parts : nullptr);
                  }),
                  workers, choices, kept) {
  if (kept != nullptr) {
    kept->parts.forget_unused();
  }
}

LoadedScene::LoadedScene(const SceneSource& scene_source, Scene made_scene, const Workers& workers,
                         const SceneChoices& choices)
    : LoadedScene(scene_source, std::pair(std::move(made_scene), 0.0), workers, choices, nullptr) {}

LoadedScene::LoadedScene(const SceneSource& scene_source, std::pair<Scene, double> timed_scene,
                         const Workers& workers, const SceneChoices& choices, KeptForReload* kept)
    : source(scene_source),
      load_seconds(timed_scene.second),
      has_studio_light(choices.lights_unlit && !has_light(timed_scene.first)),
      scene(as_chosen(std::move(timed_scene.first), choices.diffuse, has_studio_light)),
      tracer(build(scene, workers, kept, build_seconds)),
      warnings(scene.warnings),
      camera(choose_camera(source, scene, tracer.ray_scene(), choices, warnings)),
      camera_is_enclosed(is_enclosed(tracer.ray_scene(), camera.position)) {
  for (std::string& warning : tracer.warnings()) {
    warnings.push_back(std::move(warning));
  }
  if (choices.learns_lights) {
    const SteadyClock clock;
    const Nanoseconds start = clock.now();
    tracer.learn_lights(camera.position, workers);
    build_seconds += seconds(clock.now() - start);
  }
  for (std::string& lack : lacks_of(scene, camera_is_enclosed, has_studio_light)) {
    warnings.push_back(std::move(lack));
  }
}

ProgressiveSettings LoadedScene::rendered_with(ProgressiveSettings settings) const {
  settings.viewpoint = camera.position;
  if (settings.adaptive) {
    settings.adaptive->exposure_stops = source.exposure_stops.value_or(0.0);
  }
  return settings;
}

SceneReloader::SceneReloader(const LoadedScene& first, KeptForReload& kept, Settings settings)
    : settings_(std::move(settings)),
      kept_(&kept),
      workers_(settings_.threads),
      watch_(settings_.timing) {
  watch_files_of(first);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

std::optional<ReloadedScene> SceneReloader::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(reloaded_, std::nullopt);
}

void SceneReloader::run(const std::stop_token& stop) {
  const WorkScope scope(stop);
  try {
    reload_until(stop);
  } catch (const WorkStopped&) {  // the result is no longer wanted
  }
}

void SceneReloader::reload_until(const std::stop_token& stop) {
  if (kept_->parts.places_instances) {
    reload();  // The first change, like later ones, then reuses memory.
  }
  std::string last_refusal;
  for (FileChange change = watch_.wait_for_change(stop); change != FileChange::none;
       change = watch_.wait_for_change(stop)) {
    // A scene that failed to load may lack an unknown file.
    if (change == FileChange::of_another_file && last_refusal.empty()) {
      continue;
    }
    const Nanoseconds changed = clock_.now();
    is_loading_ = true;
    ReloadedScene reloaded = reload();
    is_loading_ = false;
    reloaded.changed = changed;
    const bool is_known = change == FileChange::of_another_file && reloaded.refusal == last_refusal;
    last_refusal = reloaded.refusal;
    if (!is_known) {
      const std::lock_guard lock(mutex_);
      reloaded_ = std::move(reloaded);
    }
  }
}

ReloadedScene SceneReloader::reload() {
  ReloadedScene reloaded;
  try {
    // After one change, others follow.
    kept_->expects_changes();
    // Learning would take up to 0.1 s of the 0.3 s within which a change should be visible.
    SceneChoices choices = settings_.choices;
    choices.learns_lights = false;
    reloaded.scene =
        std::make_shared<const LoadedScene>(settings_.find_source(), workers_, choices, kept_);
    watch_files_of(*reloaded.scene);
  } catch (const std::exception& error) {
    reloaded.scene = nullptr;
    reloaded.refusal = error.what();
  }
  return reloaded;
}

void SceneReloader::watch_files_of(const LoadedScene& loaded) { watch_.watch(files_of(loaded)); }

}  // namespace foveola
