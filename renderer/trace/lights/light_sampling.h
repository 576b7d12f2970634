// Light sampling of next-event estimation: settings, shading points and samples. Settings other
// than the defaults exist to measure the defaults' gain.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// Method of choosing among several lights.
enum class LightSelection : std::uint8_t {
  usual,           ///< many lights by their potential contribution to the shading point
  by_power_alone,  ///< independent of the shading point
  /// Equal probability for each emissive triangle, point, spot and sun, and for the environment.
  uniform,
};

struct LightSampling {
  LightSelection selection = LightSelection::usual;
  /// Samples all emissive triangles uniformly in area, even near ones.
  bool triangles_by_area = false;
  /// Samples environment directions with density cosine / pi around the surface's normal, whatever
  /// the sky's brightness.
  bool environment_by_cosine = false;
  /// With the default selection, learns which lights reach which part of the scene: see
  /// PathTracer::learn_lights().
  bool learns = true;

  bool operator==(const LightSampling&) const = default;
};

/// Number: float, or Floats.
template <typename Number>
struct LocalLightSampleOf {
  Vec3Of<Number> to_light{};  ///< from the shading point to the sample, not of unit length
  Number pdf{};               ///< per steradian; for a delta light: a probability; 0: no light
  Vec3Of<Number> radiance{};  ///< for a delta light: the irradiance at normal incidence
  /// Whether the light is a delta light.
  MaskOf<Number> is_delta{};
};
using LocalLightSample = LocalLightSampleOf<float>;

struct DistantLight {
  Rgb radiance{0.0F};
  float pdf = 0.0F;  ///< per steradian, of next-event estimation for this direction
};

struct ShadingPoint {
  Vec3 position{0.0F};
  Vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit length; geometric, not shading normal
  bool transmits = true;          ///< light may arrive from both sides, not only the normal's
  std::uint32_t region = 0;       ///< see Lights::region_of()
};

/// One ShadingPoint per lane, lit from their normals' side only.
struct ShadingPoints {
  Vec3Lanes position;
  Vec3Lanes normal;
  UintLanes region{};

  ShadingPoint at(std::size_t lane) const {
    return {.position = position.at(lane),
            .normal = normal.at(lane),
            .transmits = false,
            .region = region[lane]};
  }
};

}  // namespace foveola
