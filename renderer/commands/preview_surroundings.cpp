#include "renderer/commands/preview_surroundings.h"

#include "renderer/base/utf8.h"

namespace foveola {

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
