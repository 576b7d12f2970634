#include "renderer/commands/preview/preview_head.h"

#include <utility>

#include "renderer/base/text/utf8.h"
#include "renderer/gaze/recordings.h"

namespace foveola {

PreviewHead::PreviewHead(const std::vector<HeadPose>& replayed, LiveDisplay& display,
                         const AzimuthElevation& heading, const Clock& clock)
    : steered_(heading) {
  if (!replayed.empty()) {
    replayed_.emplace(replayed_head(replayed, clock.now()));
  } else if (display.headset() != nullptr) {
    worn_.emplace(display.headset()->motion());
    worn_->face(heading);
  }
}

HeadTracker& PreviewHead::shown() {
  if (replayed_) {
    return *replayed_;
  }
  return worn_ ? static_cast<HeadTracker&>(*worn_) : steered_;
}

FreeCamera PreviewHead::camera_in(CameraSurroundings surroundings) {
  if (replayed_) {
    return {std::move(surroundings), *replayed_, "a recording"};
  }
  if (worn_) {
    return {std::move(surroundings), *worn_, "the headset"};
  }
  return {std::move(surroundings), steered_};
}

CameraSurroundings surroundings_of(const LoadedScene& loaded) {
  const auto look = [&loaded](const Vec3& from, const Vec3& direction) {
    const std::optional<Picked> picked = loaded.tracer.pick(from, direction);
    if (!picked) {
      return std::optional<Sighted>();
    }
    const auto material = static_cast<std::size_t>(picked->material);
    return std::optional(Sighted{.object = printable(loaded.scene.object_name(picked->object)),
                                 .material = printable(loaded.scene.materials[material].name),
                                 .position = picked->position,
                                 .distance_m = picked->distance_m,
                                 .bounds = loaded.scene.bounds_of(picked->object)});
  };
  return {.bounds = loaded.scene.bounds(),
          .origin = loaded.scene.origin,
          .start = {.position = loaded.camera.position, .heading = loaded.camera.heading},
          .look = look};
}

}  // namespace foveola
