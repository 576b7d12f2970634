#include "scenes/studio_car/pose.h"

#include <cmath>

namespace foveola::scenes {

DMat4 facing(const DVec3& position, const DVec3& direction) {
  const DVec3 z = glm::normalize(direction);
  const DVec3 helper = std::abs(z.y) < 0.99 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
  const DVec3 x = glm::normalize(glm::cross(helper, z));
  const DVec3 y = glm::cross(z, x);
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(position, 1.0)};
}

}  // namespace foveola::scenes
