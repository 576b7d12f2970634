// What a ray scene says of shadow rays, for tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/trace/ray_scene.h"

namespace foveola::test {

struct ShadowAnswer {
  bool is_blocked;
  bool met_thin_surface;
  std::uint32_t key;  ///< the ray's, afterwards
};

/// Of all the rays, asked eight at a time. Their t_min must be 0.
inline std::vector<ShadowAnswer> ask_blocked(const RayScene& scene, std::span<const Ray> rays) {
  std::vector<ShadowAnswer> answers;
  for (std::size_t first = 0; first < rays.size(); first += lane_count) {
    const std::span<const Ray> some =
        rays.subspan(first, std::min(lane_count, rays.size() - first));
    Vec3Lanes origin{};
    Vec3Lanes direction{};
    FloatLanes t_max{};
    UintLanes key{};
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      origin.put(lane, some[lane].origin);
      direction.put(lane, some[lane].direction);
      t_max[lane] = some[lane].t_max;
      key[lane] = some[lane].key;
    }
    RayLanes lanes(origin.load(), direction.load(), t_max.load(), key.load());
    const LaneMask blocked = scene.find_blocked(lanes, mask_of((1U << some.size()) - 1U));
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      answers.push_back({.is_blocked = blocked[lane] != 0,
                         .met_thin_surface = lanes.flags[lane] != 0,
                         .key = lanes.key[lane]});
    }
  }
  return answers;
}

}  // namespace foveola::test
