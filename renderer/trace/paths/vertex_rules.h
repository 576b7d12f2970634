// Rules and random numbers of path vertices, shared by the general path and the fast path.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/lanes.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights/lights.h"
#include "renderer/trace/materials/bsdf.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/surfaces/surface.h"

namespace foveola {

struct GroupNumbers;

/// The random numbers that a vertex uses; others need not be computed.
struct NeededNumbers {
  bool light_kind;    ///< there are lights of several kinds
  bool light_choice;  ///< there are several lights of one kind
  bool lobe;          ///< there are surfaces with several lobes
  bool roulette;
  bool keys;  ///< there are surfaces that only some rays meet
};

/// The random numbers of one vertex, in this order. Each has a fixed dimension.
struct VertexNumbers {
  float light_kind, lobe, roulette;
  Vec2 light_choice, light_point, scattering;
  std::uint32_t shadow_key, next_key;

  explicit VertexNumbers(SampleStream& random) {
    light_kind = random.next_1d();
    light_choice = random.next_2d();
    light_point = random.next_2d();
    lobe = random.next_1d();
    scattering = random.next_2d();
    roulette = random.next_1d();
    shadow_key = random.next_bits();
    next_key = random.next_bits();
  }

  /// The numbers of a lane in a group.
  VertexNumbers(const GroupNumbers& group, std::size_t lane);
};

/// The random numbers of a group of paths; unused ones are 0.
struct GroupNumbers {
  LightNumbers light{};
  Floats lobe{}, roulette{};
  Vec2s scattering;
  Uints shadow_key{}, next_key{};

  GroupNumbers(SampleStreams& random, const NeededNumbers& needed) {
    if (needed.light_kind) {
      light.kind.store(random.next_1d());
    } else {
      random.skip(1);
    }
    if (needed.light_choice) {
      light.choice.store(random.next_2d());
    } else {
      random.skip(1);
    }
    light.point.store(random.next_2d());
    if (needed.lobe) {
      lobe = random.next_1d();
    } else {
      random.skip(1);
    }
    scattering = random.next_2d();
    if (needed.roulette) {
      roulette = random.next_1d();
    } else {
      random.skip(1);
    }
    if (needed.keys) {
      shadow_key = random.next_bits();
      next_key = random.next_bits();
    } else {
      random.skip(2);
    }
  }
};

inline VertexNumbers::VertexNumbers(const GroupNumbers& group, std::size_t lane)
    : light_kind(group.light.kind[lane]),
      lobe(group.lobe[lane]),
      roulette(group.roulette[lane]),
      light_choice(group.light.choice.at(lane)),
      light_point(group.light.point.at(lane)),
      scattering(group.scattering.x[lane], group.scattering.y[lane]),
      shadow_key(group.shadow_key[lane]),
      next_key(group.next_key[lane]) {}

/// The BSDF of a surface for a ray's direction, in the frame of its shading normal.
inline Bsdf bsdf_at(const SurfacePoint& point, const Frame& frame, const Vec3& direction,
                    const ScatteringTables& tables) {
  const Vec3 coat_normal = point.coat_normal == point.shading_normal
                               ? Vec3(0.0F, 0.0F, 1.0F)
                               : frame.to_local(point.coat_normal);
  return Bsdf(point.reflectance, frame.to_local(-direction), tables, coat_normal);
}

/// Factor on the survival probability: paths with at least half the camera's throughput always
/// survive. Relative to 1 it costs 5 to 26 % more rays and removes 13 to 33 % of the variance.
inline constexpr float roulette_margin = 2.0F;

/// Survival probability of a path whose brightest throughput channel is `brightest`; values >= 1
/// survive surely. A number, or lanes of them.
template <typename Number>
inline Number survival(const Number& brightest) {
  return roulette_margin * brightest;
}

/// Maximum number of thin transmissive surfaces that a ray passes without a vertex, so that no
/// scene traps a path.
inline constexpr int max_thin_surfaces = 256;

/// The density of a direction that no light sample can have: a camera's or a mirror's.
inline constexpr float certain = std::numeric_limits<float>::infinity();

/// The power heuristic with exponent 2 (Veach 1997, section 9.2.4) for a sample of density `pdf`
/// that could also have come from a strategy of density `other`. Computed as a ratio, which cannot
/// become infinity over infinity. A number, or lanes of them.
template <typename Number>
inline Number power_heuristic(const Number& pdf, const Number& other) {
  const Number ratio = other / pdf;
  return chosen(pdf == certain, Number{} + 1.0F, 1.0F / (1.0F + ratio * ratio));
}

/// A number of light samples beside which a scattered ray has no weight in the power heuristic,
/// wherever light samples exist.
inline constexpr float overwhelmingly_many = 0x1p100F;

/// A light sample's contribution to a path if its shadow ray is not blocked. value: of the BSDF,
/// for the sample's direction. light_density: of the light sample, for the heuristic.
template <typename Number>
inline Vec3Of<Number> direct_light(const Vec3Of<Number>& throughput,
                                   const BsdfValueOf<Number>& value,
                                   const LightSampleOf<Number>& light,
                                   const Number& light_density) {
  const Number weight =
      chosen(light.is_delta, Number{} + 1.0F, power_heuristic(light_density, value.pdf));
  return (weight / light.pdf) * (throughput * value.times_cosine * light.radiance);
}

/// The direction of the shadow ray from `origin` to a light sample drawn for `position`, with the
/// same end.
template <typename Number>
inline Vec3Of<Number> shadow_direction(const LightSampleOf<Number>& light,
                                       const Vec3Of<Number>& position,
                                       const Vec3Of<Number>& origin) {
  return chosen(light.t_max < std::numeric_limits<float>::infinity(),
                light.to_light + (position - origin), light.to_light);
}

// Textures are filtered over much less than a ray's footprint. A wide filter includes texels that
// the surface does not show: in Crytek's Sponza a whole pixel and a tenth of the scattered cone
// made the picture 2 % brighter, a bias that samples do not remove (STABILITY.md).

/// Spread of a camera ray: an eighth of its pixel, pbrt-v4's minimum (Camera::Approximate_dp_dxy),
/// within the samples' own spread.
inline float camera_spread_rad(float pixel_angle_rad) { return 0.125F * pixel_angle_rad; }

/// Spread of a scattered ray: a two-hundredth of the cone with one sample's solid angle. A number,
/// or lanes of them.
template <typename Number>
inline Number scattered_spread_rad(const Number& pdf) {
  constexpr float widest_rad = 0.02F;
  return smaller(0.005F / square_root(pdf), widest_rad);
}

/// The radiance of a path with non-finite values.
inline constexpr Rgb not_a_number(std::numeric_limits<float>::quiet_NaN());

/// Transmittance over a distance in metres, which may be infinite.
inline Rgb transmittance(const Rgb& absorption_per_m, float distance_m) {
  const auto left = [&](float absorption) {
    return absorption > 0.0F ? std::exp(-absorption * distance_m) : 1.0F;
  };
  return {left(absorption_per_m.r), left(absorption_per_m.g), left(absorption_per_m.b)};
}

}  // namespace foveola
