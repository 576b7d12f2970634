// Random points for tests of lights and materials.
#pragma once

#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola::test {

/// Uniform in [0, 1)².
inline Vec2 unit_square(Pcg32& random) {
  const float x = unit_float(random.next());
  const float y = unit_float(random.next());
  return {x, y};
}

/// Uniform in [−half, half)³.
inline Vec3 in_cube(Pcg32& random, float half = 1.0F) {
  const double x = random.uniform();
  const double y = random.uniform();
  const double z = random.uniform();
  return half * (2.0F * Vec3(x, y, z) - 1.0F);
}

/// Within half of the origin along each axis.
inline ShadingPoint random_shading_point(Pcg32& random, float half) {
  const Vec3 position = in_cube(random, half);
  const Vec3 normal = glm::normalize(in_cube(random));
  return {.position = position, .normal = normal, .transmits = random.uniform() < 0.3};
}

}  // namespace foveola::test
