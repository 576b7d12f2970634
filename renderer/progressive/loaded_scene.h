// A scene ready for rendering: loaded, built for tracing, with a camera, and reloaded when its
// files change.
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

/// The user's choices that override the scene's.
struct SceneChoices {
  std::optional<DVec3> camera;           ///< in the file's world; default: see LoadedScene::camera
  std::string camera_name;               ///< see camera_names(); empty: no choice
  std::optional<AzimuthElevation> head;  ///< world, with a level horizon; default: the camera's
  /// Field of view of the picture for which a viewpoint is chosen.
  std::optional<FieldOfView> framed_for;  ///< default: the default picture's
  bool diffuse = false;       ///< every material is Lambertian in its base colour, emission kept
  bool lights_unlit = false;  ///< adds a studio light to a scene without emission
  /// Whether light probabilities are learned at the camera (see PathTracer::learn_lights).
  bool learns_lights = true;
};

/// Parts of a loaded and built scene, kept for its next version.
struct KeptForReload {
  KeptSceneParts parts;
  KeptHierarchies hierarchies;

  /// Optimises later loads for fast reloading: one hierarchy per mesh, which makes rays a third
  /// slower.
  void expects_changes() { parts.places_instances = true; }
};

struct LoadedScene {
  SceneSource source;
  double load_seconds = 0.0;
  double build_seconds = 0.0;
  bool has_studio_light = false;  ///< whether it is the only light
  Scene scene;
  PathTracer tracer;
  /// One line each: warnings of loading, the viewpoint if neither scene nor choices have one (see
  /// choose_standpoint), and what the scene lacks.
  std::vector<std::string> warnings;
  /// By the choices, else the source, else the file's first camera, else choose_standpoint; in the
  /// scene's coordinates (see Scene::origin).
  CameraView camera;
  /// Whether no light reaches the camera's place from outside the scene.
  bool camera_is_enclosed = false;

  /// kept: stores parts for reuse, or null. Throws Error for a fault of the scene, and UsageError
  /// for a camera that it lacks.
  LoadedScene(const SceneSource& source, const Workers& workers, const SceneChoices& choices = {},
              KeptForReload* kept = nullptr);
  /// For a scene without a file.
  LoadedScene(const SceneSource& source, Scene scene, const Workers& workers,
              const SceneChoices& choices = {});
  LoadedScene(const LoadedScene&) = delete;
  LoadedScene& operator=(const LoadedScene&) = delete;

  /// `settings` with this scene's viewpoint and exposure.
  ProgressiveSettings rendered_with(ProgressiveSettings settings) const;

 private:
  /// timed_scene: the scene, and the seconds of loading it.
  LoadedScene(const SceneSource& source, std::pair<Scene, double> timed_scene,
              const Workers& workers, const SceneChoices& choices, KeptForReload* kept);
};

/// The result of reloading changed files.
struct ReloadedScene {
  std::shared_ptr<const LoadedScene> scene;  ///< null if loading failed
  std::string refusal;                       ///< the reason of a failure
  Nanoseconds changed{0};                    ///< when the change was complete, by the steady clock
};

/// Reloads a scene in a thread of its own, once its files are no longer written to. Unchanged parts
/// are neither decoded nor built again.
class SceneReloader {
 public:
  struct Settings {
    /// Finds the scene again: its descriptor may have changed too.
    std::function<SceneSource()> find_source;
    SceneChoices choices;
    int threads = 0;  ///< 0: one per core
    FileWatchTiming timing;
  };

  /// first: the scene shown. kept: the parts of its loading; must outlive this. Throws Error if the
  /// system does not allow watching its folders.
  SceneReloader(const LoadedScene& first, KeptForReload& kept, Settings settings);

  /// The result of the last change, once; nullopt before. Does not wait.
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
  std::jthread thread_;  ///< last: it ends before the members that it uses
};

}  // namespace foveola
