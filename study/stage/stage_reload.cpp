#include "study/stage/stage_reload.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/transformed.h"

namespace foveola::study {
namespace {

std::vector<std::string> names_of(const std::vector<OfferedObject>& objects) {
  return transformed(objects, &OfferedObject::name);
}

}  // namespace

StageReloader::StageReloader(const SceneStages& stages, const FindScene& find_scene, int threads) {
  for (const auto& [name, stage] : stages) {
    auto kept = std::make_unique<KeptForReload>();
    auto reloader = std::make_unique<SceneReloader>(
        stage->loaded(), *kept,
        SceneReloader::Settings{
            .find_source = [find_scene, scene = name] { return as_shown(find_scene(scene)); },
            .threads = threads});
    watched_.push_back({.scene = name,
                        .objects = names_of(stage->objects()),
                        .kept = std::move(kept),
                        .reloader = std::move(reloader)});
  }
}

std::optional<ReloadedStage> StageReloader::take_reloaded() {
  for (const Watched& watched : watched_) {
    if (const std::optional<ReloadedScene> reloaded = watched.reloader->take()) {
      return staged(watched, *reloaded);
    }
  }
  return std::nullopt;
}

bool StageReloader::is_loading() const {
  return std::ranges::any_of(watched_,
                             [](const Watched& watched) { return watched.reloader->is_loading(); });
}

ReloadedStage StageReloader::staged(const Watched& watched, const ReloadedScene& reloaded) {
  ReloadedStage changed{.scene = watched.scene, .stage = nullptr, .refusal = reloaded.refusal};
  if (reloaded.scene == nullptr) {
    return changed;
  }
  auto stage = std::make_unique<const SceneStage>(reloaded.scene);
  const std::vector<std::string> objects = names_of(stage->objects());
  if (objects != watched.objects) {
    changed.refusal = fmt::format("its objects are {}, not {}; begin the session anew to use them",
                                  fmt::join(objects, ", "), fmt::join(watched.objects, ", "));
    return changed;
  }
  changed.stage = std::move(stage);
  return changed;
}

}  // namespace foveola::study
