// What a ray scene says of shadow rays, for tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/trace/rays/ray_scene.h"

namespace foveola::test {

struct ShadowAnswer {
  bool is_blocked;
  bool met_thin_surface;
  std::uint32_t key;  ///< the ray's, afterwards
};

/// Of all the rays, asked as one stream. Their t_min must be 0.
inline std::vector<ShadowAnswer> ask_blocked(const RayScene& scene, std::span<const Ray> rays) {
  RayStream stream(8);
  for (const Ray& ray : rays) {
    stream.add(ray.origin, ray.direction, ray.t_max, ray.key);
  }
  scene.find_blocked(stream);
  std::vector<ShadowAnswer> answers;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    answers.push_back({.is_blocked = stream.is_blocked(i),
                       .met_thin_surface = stream.met_thin_surface(i),
                       .key = stream.key(i)});
  }
  return answers;
}

}  // namespace foveola::test
