// A scene ready to be rendered: loaded, built for tracing, with a camera chosen for it, and loaded
// again whenever its files change.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/files/file_watch.h"
#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/paths/path_tracer.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// What a user may choose otherwise than the scene has it.
struct SceneChoices {
  std::optional<DVec3> camera;           ///< in the file's world; default: see LoadedScene::camera
  std::string camera_name;               ///< see camera_names(); empty: no choice
  std::optional<AzimuthElevation> head;  ///< world, with its horizon level; default: the camera's
  /// The field of view of the picture that a place to stand is chosen for.
  std::optional<FieldOfView> framed_for;  ///< default: the usual picture's
  bool diffuse = false;       ///< every material is Lambertian in its base colour, emission kept
  bool lights_unlit = false;  ///< a scene in which nothing shines gets a studio light
  /// Which lights reach where is learned from the camera's place (see PathTracer::learn_lights).
  bool learns_lights = true;
};

/// What loading and building a scene made, kept for its next version.
struct KeptForReload {
  KeptSceneParts parts;
  KeptHierarchies hierarchies;

  /// From now on scenes are loaded so that changes are loaded soon: with a hierarchy for each mesh,
  /// through which rays take a third longer.
  void expects_changes() { parts.places_instances = true; }
};

struct LoadedScene {
  SceneSource source;
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  bool has_studio_light = false;  ///< whether only that lights it
  Scene scene;
  PathTracer tracer;
  /// One line each: what loading warned of, where one stands if neither the scene nor the choices
  /// say so (see choose_standpoint), and what the scene lacks.
  std::vector<std::string> warnings;
  /// Where the choices say, else the source, else the file's first, else by choose_standpoint; in
  /// the scene's coordinates (see Scene::origin).
  CameraView camera;
  /// Whether no light comes to the camera's place from outside the scene.
  bool camera_is_enclosed = false;

  /// kept: what is used again and left for the next version, or null. Throws Error for what is
  /// wrong with the scene, and UsageError for a camera that it has not.
  LoadedScene(const SceneSource& source, const Workers& workers, const SceneChoices& choices = {},
              KeptForReload* kept = nullptr);
  /// For a scene that comes from no file.
  LoadedScene(const SceneSource& source, Scene scene, const Workers& workers,
              const SceneChoices& choices = {});
  LoadedScene(const LoadedScene&) = delete;
  LoadedScene& operator=(const LoadedScene&) = delete;

  /// `settings` of a render of this scene: with its viewpoint and its exposure.
  ProgressiveSettings rendered_with(ProgressiveSettings settings) const;

 private:
  /// The scene and the seconds that loading it took.
  LoadedScene(const SceneSource& source, std::pair<Scene, double> timed_scene,
              const Workers& workers, const SceneChoices& choices, KeptForReload* kept);
};

/// What became of a change of a scene's files.
struct ReloadedScene {
  std::shared_ptr<const LoadedScene> scene;  ///< null: it does not load
  std::string refusal;                       ///< why, then
  Nanoseconds changed{0};                    ///< when the change was complete, by the steady clock
};

/// In a thread of its own. Files are read once nobody writes to them any more. What has not changed
/// is neither decoded nor built again.
class SceneReloader {
 public:
  struct Settings {
    /// Finds the scene again, as it was found first: its descriptor may have changed too.
    std::function<SceneSource()> find_source;
    SceneChoices choices;
    int threads = 0;  ///< 0: one for each core
    FileWatchTiming timing;
  };

  /// first: what is shown. kept: what loading that left, which must outlive this. Throws Error if
  /// the system does not let its folders be watched.
  SceneReloader(const LoadedScene& first, KeptForReload& kept, Settings settings);

  /// What came of the last change, once. Does not wait.
  std::optional<ReloadedScene> take();

  /// Whether a change is being loaded.
  bool is_loading() const { return is_loading_; }

 private:
  void run(const std::stop_token& stop);
  void reload_until(const std::stop_token& stop);
  ReloadedScene reload();
  void watch_files_of(const LoadedScene& loaded);

  Settings settings_;
  KeptForReload* kept_;
  Workers workers_;
  SteadyClock clock_;
  FileWatch watch_;
  std::atomic<bool> is_loading_ = false;
  std::mutex mutex_;
  std::optional<ReloadedScene> reloaded_;
  std::jthread thread_;  ///< ends before what it uses
};

}  // namespace foveola
