// Prepares a protocol's scene for trials: loads it, with its objects and its converged image.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/image/image.h"
#include "renderer/measure/reference.h"
#include "renderer/progressive/loaded_scene.h"
#include "study/protocol/protocol.h"
#include "study/record/write/study_store.h"
#include "study/stage/offered_object.h"

namespace foveola::study {

/// Returns a hash of the file and its additions, to distinguish scenes of different looks.
std::string scene_key(const LoadedScene& loaded);

/// Returns `source` with the strictness of studies: incomplete scenes are refused.
SceneSource as_shown(SceneSource source);

class SceneStage {
 public:
  /// Loads the scene and builds its tracer. source has a camera position and objects (see
  /// find_scenes). Throws Error for a bad file.
  SceneStage(const SceneSource& source, const Workers& workers);
  /// A stage of a scene that was loaded from an as_shown source.
  explicit SceneStage(std::shared_ptr<const LoadedScene> loaded);
  SceneStage(const SceneStage&) = delete;
  SceneStage& operator=(const SceneStage&) = delete;

  /// Renders the converged image for such a film, or takes it from the cache. Throws Error if
  /// stopped.
  void render_reference(const FilmSettings& film, const ReferenceQuality& quality,
                        const Workers& workers, const std::function<void(double)>& progress,
                        const std::stop_token& stop);

  /// Returns whether the cache has it complete.
  bool has_reference(const FilmSettings& film, const ReferenceQuality& quality) const;

  std::string key() const { return scene_key(*loaded_); }
  const LoadedScene& loaded() const { return *loaded_; }
  const SceneSource& source() const { return loaded_->source; }
  const Scene& scene() const { return loaded_->scene; }
  const PathTracer& tracer() const { return loaded_->tracer; }
  const Vec3& viewpoint() const { return loaded_->camera.position; }
  const std::vector<OfferedObject>& objects() const { return objects_; }
  /// Linear radiance, as large as the film; empty before render_reference.
  const RgbImage& reference() const { return reference_; }

 private:
  ReferenceSettings reference_settings(const FilmSettings& film,
                                       const ReferenceQuality& quality) const;

  std::shared_ptr<const LoadedScene> loaded_;
  std::vector<OfferedObject> objects_;
  RgbImage reference_;
};

using SceneStages = std::map<std::string, std::unique_ptr<SceneStage>>;

/// sources: the protocol's scenes, in its order (see find_scenes). Throws Error for a bad file.
SceneStages load_stages(const Protocol& protocol, const std::vector<SceneSource>& sources,
                        const Workers& workers);

/// Returns the scenes as they are recorded.
std::vector<ShownScene> shown_scenes(const SceneStages& stages);

/// Prints loading's warnings on standard error, a line each: for instance, another file than the
/// descriptor's, or an interpretation of lights.
void print_scene_warnings(const SceneStages& stages);

}  // namespace foveola::study
