#include "renderer/view/view_sampler.h"

#include <algorithm>

namespace foveola {

double density_around(const ViewSampler& sampler, const Vec3& direction) {
  const double density = sampler.density_per_sr(direction);
  if (density > 0.0) {
    return density;
  }
  constexpr auto distance = static_cast<float>(radians(0.01));
  const Frame frame(direction);
  double largest = 0.0;
  for (const Vec3& aside : {Vec3(distance, 0.0F, 0.0F), Vec3(-distance, 0.0F, 0.0F),
                            Vec3(0.0F, distance, 0.0F), Vec3(0.0F, -distance, 0.0F)}) {
    const Vec3 place = glm::normalize(frame.to_world(aside + Vec3(0.0F, 0.0F, 1.0F)));
    largest = std::max(largest, sampler.density_per_sr(place));
  }
  return largest;
}

}  // namespace foveola
