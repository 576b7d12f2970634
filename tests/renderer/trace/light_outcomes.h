// A scene with every kind of light, and made-up outcomes of samples of its lights.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/numbers/random.h"
#include "renderer/trace/lights/lights.h"
#include "scenes.h"
#include "tests/renderer/trace/random_points.h"

namespace foveola::test {

/// Every kind of light at once: near and far triangles of one colour and of many, points with and
/// without size, a sun with and without size, and a sky.
inline Scene every_light() {
  Scene scene;
  scene.materials = {emitter(4.0F, /*double_sided=*/true), emitter(2.0F)};
  scene.meshes = {quad(Vec3(0, 2, 0), Vec3(1, 0, 0), Vec3(0, 0, 3), 0),
                  quad(Vec3(-9, 30, -9), Vec3(18, 0, 0), Vec3(0, 0, 18), 1)};
  scene.environment = constant_environment(0.5F);
  scene.lights = {{.position = Vec3(1, 1, 1)},
                  {.position = Vec3(-1, 2, 1), .radius_m = 0.3F},
                  {.kind = PunctualLight::Kind::directional, .direction = Vec3(0, -1, 0)},
                  {.kind = PunctualLight::Kind::directional,
                   .direction = Vec3(0, -0.8F, 0.6F),
                   .angular_radius_rad = 0.1F}};
  return scene;
}

/// Of which nothing arrived.
inline std::vector<LightOutcome> outcomes_of(const Lights& lights, std::size_t count) {
  std::vector<LightOutcome> outcomes;
  Pcg32 random(5);
  for (std::size_t i = 0; i < count; ++i) {
    const ShadingPoint point = random_shading_point(random, 2.0F);
    const float u_kind = unit_float(random.next());
    const Vec2 u_choice = unit_square(random);
    outcomes.push_back(lights.outcome(point, u_kind, u_choice, unit_square(random)));
  }
  return outcomes;
}

/// On the side of x > 0 only the upper half of the sky arrives, and on the other only every other
/// light that stands in the scene.
inline std::vector<LightOutcome> two_sided_outcomes(const Lights& lights, std::size_t count) {
  std::vector<LightOutcome> outcomes = outcomes_of(lights, count);
  for (LightOutcome& outcome : outcomes) {
    const bool arrives = outcome.shading_point.position.x > 0.0F
                             ? outcome.kind == LightKind::environment && outcome.light < 32
                             : outcome.kind == LightKind::local && outcome.light % 2 == 0;
    outcome.gain = arrives ? 1.0F : 0.0F;
  }
  return outcomes;
}

inline void learn_two_sides(Lights& lights) { lights.learn(two_sided_outcomes(lights, 40'000)); }

}  // namespace foveola::test
