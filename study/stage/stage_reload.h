// Reloads scenes of a protocol when their files change, in rehearsals only: measured participants
// see one scene all the time.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/progressive/loaded_scene.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// Result of a change of a scene's files.
struct ReloadedStage {
  std::string scene;                        ///< name in the protocol
  std::unique_ptr<const SceneStage> stage;  ///< null: it cannot be shown
  std::string refusal;                      ///< the reason, if so
};

class StageReloader {
 public:
  using FindScene = std::function<SceneSource(const std::string& scene)>;

  /// Watches the files of `stages`. find_scene finds a scene as at first. threads: 0: one per core.
  /// Throws Error if the system cannot watch their folders.
  StageReloader(const SceneStages& stages, const FindScene& find_scene, int threads);

  /// Returns the result of a scene's last change, once; several scenes come one by one. A scene
  /// with other objects' names than at first is refused, because trials refer to them. Does not
  /// wait.
  std::optional<ReloadedStage> take_reloaded();

  /// Returns whether a change is being loaded.
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
