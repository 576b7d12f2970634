// How next-event estimation draws light: its settings, the point whose incoming light is sampled,
// and what drawing gives. What is not the usual way is there to measure what the usual way gains.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// How a light is drawn where there are several.
enum class LightSelection : std::uint8_t {
  usual,           ///< many lights by what they may give to the shading point
  by_power_alone,  ///< wherever the shading point is
  /// Each emissive triangle, point, spot and sun is as likely as any other, and as the environment.
  uniform,
};

struct LightSampling {
  LightSelection selection = LightSelection::usual;
  /// Points are uniform in the area of emissive triangles, even of those that are near.
  bool triangles_by_area = false;
  /// Directions to the environment have the density cosine / pi around the surface's normal,
  /// wherever the sky is bright.
  bool environment_by_cosine = false;
  /// Of the usual selection, which lights reach which part of the scene is learned: see
  /// PathTracer::learn_lights().
  bool learns = true;

  bool operator==(const LightSampling&) const = default;
};

/// Number: float, or Floats.
template <typename Number>
struct LocalLightSampleOf {
  Vec3Of<Number> to_light{};  ///< from the place to the point, not of unit length
  Number pdf{};               ///< per steradian; without size: a probability; 0: no light
  Vec3Of<Number> radiance{};  ///< without size: the irradiance that it gives head-on
  /// The light has no size.
  MaskOf<Number> is_delta{};
};
using LocalLightSample = LocalLightSampleOf<float>;

struct DistantLight {
  Rgb radiance{0.0F};
  float pdf = 0.0F;  ///< per steradian, with which next-event estimation draws its direction
};

struct ShadingPoint {
  Vec3 position{0.0F};
  Vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit length; of the geometry, not of its shading
  bool transmits = true;          ///< light may arrive from both sides, not from the normal's alone
  std::uint32_t region = 0;       ///< see Lights::region_of()
};

/// ShadingPoints that light arrives at from their normal's side only, one a lane.
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
