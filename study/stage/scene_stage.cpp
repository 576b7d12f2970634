#include "study/stage/scene_stage.h"

#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/files/cache.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "renderer/base/transformed.h"
#include "study/record/setup/shown_scene.h"

namespace foveola::study {
namespace {

std::vector<OfferedObject> objects_on_offer(const SceneSource& source) {
  return transformed(source.objects, [&](const ObjectOfInterest& object) {
    return OfferedObject{.name = object.name,
                         .direction = direction_of(object, *source.camera_position),
                         .radius_deg = object.radius_deg};
  });
}

std::filesystem::path cached_references() { return cache_folder() / "references"; }

}  // namespace

std::string scene_key(const LoadedScene& loaded) {
  return loaded.scene.sha256 + ";" + added_to_file(loaded.source);
}

SceneSource as_shown(SceneSource source) {
  source.strict = true;
  return source;
}

// Simulated participants, and the machine model's samples per second, were calibrated without
// learned sampling.
SceneStage::SceneStage(const SceneSource& source, const Workers& workers)
    : SceneStage(std::make_shared<const LoadedScene>(as_shown(source), workers,
                                                     SceneChoices{.learns_lights = false})) {}

SceneStage::SceneStage(std::shared_ptr<const LoadedScene> loaded)
    : loaded_(std::move(loaded)), objects_(objects_on_offer(loaded_->source)) {
  assert(loaded_->source.camera_position && !objects_.empty());
}

ReferenceSettings SceneStage::reference_settings(const FilmSettings& film,
                                                 const ReferenceQuality& quality) const {
  ReferenceSettings settings;
  settings.viewpoint = viewpoint();
  settings.width = film.width;
  settings.height = film.height;
  settings.max_depth = film.max_depth;
  settings.samples_per_pixel = quality.samples_per_pixel;
  settings.samples_per_interest = static_cast<std::uint64_t>(quality.samples_per_object);
  for (const OfferedObject& object : objects_) {
    settings.interests.push_back(object.direction);
  }
  return settings;
}

void SceneStage::render_reference(const FilmSettings& film, const ReferenceQuality& quality,
                                  const Workers& workers,
                                  const std::function<void(double)>& progress,
                                  const std::stop_token& stop) {
  reference_ = reference_image(tracer(), key(), reference_settings(film, quality), workers,
                               cached_references(), progress, stop)
                   .color;
}

bool SceneStage::has_reference(const FilmSettings& film, const ReferenceQuality& quality) const {
  return is_cached(
      reference_file(cached_references(), key(), reference_settings(film, quality), build_info()));
}

SceneStages load_stages(const Protocol& protocol, const std::vector<SceneSource>& sources,
                        const Workers& workers) {
  SceneStages stages;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    stages[protocol.scenes[i].name] = std::make_unique<SceneStage>(sources[i], workers);
  }
  return stages;
}

std::vector<ShownScene> shown_scenes(const SceneStages& stages) {
  std::vector<ShownScene> shown;
  for (const auto& [name, stage] : stages) {
    shown.push_back({.name = name,
                     .file_name = stage->source().file.filename().string(),
                     .sha256 = stage->scene().sha256,
                     .shown_as = shown_as(stage->source())});
  }
  return shown;
}

void print_scene_warnings(const SceneStages& stages) {
  for (const auto& [name, stage] : stages) {
    for (const std::string& warning : stage->scene().warnings) {
      print_text(stderr, "foveola: warning: {}\n", printable(fmt::format("{}: {}", name, warning)));
    }
  }
}

}  // namespace foveola::study
