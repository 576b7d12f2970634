// Scenes of a protocol that are loaded again when their files change: in a rehearsal. Whoever is
// measured sees one scene all the time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/progressive/loaded_scene.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// What became of a change of a scene's files.
struct ReloadedStage {
  std::string scene;                        ///< its name in the protocol
  std::unique_ptr<const SceneStage> stage;  ///< null: it cannot be shown
  std::string refusal;                      ///< why, then
};

class StageReloader {
 public:
  using FindScene = std::function<SceneSource(const std::string& scene)>;

  /// Watches the files of `stages`. find_scene finds a scene as it was found first. threads: 0 for
  /// one for each core. Throws Error if the system does not let their folders be watched.
  StageReloader(const SceneStages& stages, const FindScene& find_scene, int threads);

  /// What came of the last change of a scene, once; scenes that changed at the same time come one
  /// by one. A scene whose objects have other names than at first is refused: trials that are
  /// planned or over are about them. Does not wait.
  std::optional<ReloadedStage> take();

  /// Whether a change is being loaded.
  bool is_loading() const;

 private:
  struct Watched {
    std::string scene;
    std::vector<std::string> objects;  ///< names, in the scene's order
    std::unique_ptr<KeptForReload> kept;
    std::unique_ptr<SceneReloader> reloader;
  };

  static ReloadedStage staged(const Watched& watched, const ReloadedScene& reloaded);

  std::vector<Watched> watched_;
};

}  // namespace foveola::study
