#include "renderer/progressive/scene_reload.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "renderer/base/work_scope.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// All files that the scene was made of or, like a descriptor beside its file, may be the next
/// time.
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
  } catch (const WorkStopped&) {  // nobody waits for that scene any longer
  }
}

void SceneReloader::reload_until(const std::stop_token& stop) {
  if (kept_->parts.places_instances) {
    reload();  // So that the first change, as later ones, finds memory that was in use before.
  }
  std::string last_refusal;
  for (FileChange change = watch_.wait_for_change(stop); change != FileChange::none;
       change = watch_.wait_for_change(stop)) {
    // A scene that did not load may lack a file that nobody knows of yet.
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
    // Where one change was, others follow.
    kept_->expects_changes();
    // Learning would take up to 0.1 s of the 0.3 s within which a change is to be seen.
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
