#include "renderer/scene/prepare/rebase.h"

#include <cmath>

namespace foveola {

DVec3 origin_for(const DVec3& lower, const DVec3& upper) {
  constexpr double far = 8.0;
  const DVec3 center = 0.5 * (lower + upper);
  const double half_diagonal = 0.5 * glm::length(upper - lower);
  if (!(half_diagonal > 0.0) || !std::isfinite(half_diagonal) ||
      !(glm::length(center) > far * half_diagonal)) {
    return DVec3(0.0);
  }
  const double step = std::exp2(std::floor(std::log2(half_diagonal)));
  return glm::round(center / step) * step;
}

void rebase(Scene& scene) {
  const Bounds bounds = scene.bounds();
  scene.origin = origin_for(bounds.lower, bounds.upper);
  if (scene.origin == DVec3(0.0)) {
    return;
  }
  const auto move = [&](Vec3& position) { position = scene.from_file(position); };
  for (Mesh& mesh : scene.meshes) {
    for (Vec3& position : mesh.positions) {
      move(position);
    }
  }
  for (Instance& instance : scene.instances) {
    Vec3 translation(instance.world_from_local[3]);
    move(translation);
    instance.world_from_local[3] = Vec4(translation, 1.0F);
  }
  for (PunctualLight& light : scene.lights) {
    move(light.position);
  }
  for (CameraView& camera : scene.cameras) {
    move(camera.position);
  }
}

}  // namespace foveola
