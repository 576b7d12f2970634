// Loads a scene again whenever its files change.
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

#include "renderer/base/clock.h"
#include "renderer/base/file_watch.h"
#include "renderer/progressive/loaded_scene.h"

namespace foveola {

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
