// What happens at every vertex of a path, whether it is worked on alone or with others, and the
// random numbers of vertices.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/base/angles.h"
#include "renderer/base/lanes.h"
#include "renderer/base/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights/lights.h"
#include "renderer/trace/materials/bsdf.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/scattering_tables.h"
#include "renderer/trace/surfaces/surface.h"

namespace foveola {

struct GroupNumbers;

/// Which of a vertex's numbers decide something; the others need not be computed.
struct NeededNumbers {
  bool light_kind;    ///< there are lights of several kinds
  bool light_choice;  ///< there are several lights of one kind
  bool lobe;          ///< there are surfaces with several lobes
  bool roulette;
  bool keys;  ///< there are surfaces that only some rays meet
};

/// The random numbers of one vertex, in this order. Each has its own dimension whatever was decided
/// before.
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

/// The random numbers of a group of paths; those that are not needed are 0.
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

/// How a surface scatters against a ray's direction, in the frame of its shading normal.
inline Bsdf bsdf_at(const SurfacePoint& point, const Frame& frame, const Vec3& direction,
                    const ScatteringTables& tables) {
  const Vec3 coat_normal = point.coat_normal == point.shading_normal
                               ? Vec3(0.0F, 0.0F, 1.0F)
                               : frame.to_local(point.coat_normal);
  return Bsdf(point.reflectance, frame.to_local(-direction), tables, coat_normal);
}

/// How much more often paths survive than their brightness says: those of at least half the
/// camera's always do. Ending them so much later costs 5 to 26 % more rays and takes 13 to 33 % of
/// the variance.
inline constexpr float roulette_margin = 2.0F;

/// The chance to survive of a path whose throughput's brightest channel is `brightest`, at least 1
/// if it surely does. A number, or lanes of them.
template <typename Number>
inline Number survival(const Number& brightest) {
  return roulette_margin * brightest;
}

/// Thin transmissive surfaces in line that a ray may pass without a vertex, so that no scene traps
/// a path.
inline constexpr int max_thin_surfaces = 256;

/// The density of a direction that no light sample could have given: a camera's or a mirror's.
inline constexpr float certain = std::numeric_limits<float>::infinity();

/// The power heuristic with exponent 2 (Veach 1997, section 9.2.4) for a sample of density `pdf`
/// that could also have come from a strategy of density `other`. As a ratio, which cannot overflow
/// into infinity over infinity. A number, or lanes of them.
template <typename Number>
inline Number power_heuristic(const Number& pdf, const Number& other) {
  const Number ratio = other / pdf;
  return chosen(pdf == certain, Number{} + 1.0F, 1.0F / (1.0F + ratio * ratio));
}

/// So many light samples that one scattered ray is as nothing beside them: the power heuristic then
/// gives light samples all weight wherever there can be one.
inline constexpr float overwhelmingly_many = 0x1p100F;

/// What a path of this throughput gains from a light sample if its shadow ray is not blocked.
/// value: the BSDF's, for the sample's direction. light_density: the density that the heuristic is
/// told of the light sample.
template <typename Number>
inline Vec3Of<Number> direct_light(const Vec3Of<Number>& throughput,
                                   const BsdfValueOf<Number>& value,
                                   const LightSampleOf<Number>& light,
                                   const Number& light_density) {
  const Number weight =
      chosen(light.is_delta, Number{} + 1.0F, power_heuristic(light_density, value.pdf));
  return (weight / light.pdf) * (throughput * value.times_cosine * light.radiance);
}

/// The direction of the shadow ray to a light sample, which was drawn for `position`, if it starts
/// at `origin` instead: where it ends stays.
template <typename Number>
inline Vec3Of<Number> shadow_direction(const LightSampleOf<Number>& light,
                                       const Vec3Of<Number>& position,
                                       const Vec3Of<Number>& origin) {
  return chosen(light.t_max < std::numeric_limits<float>::infinity(),
                light.to_light + (position - origin), light.to_light);
}

// Textures are averaged over much less than a ray stands for. A wide average shows parts of a
// texture that the surface does not: in Crytek's Sponza a whole pixel and a tenth of the scattered
// cone made the picture 2 % brighter, which no number of samples takes back (STABILITY.md).

/// How much a ray from the camera widens: an eighth of its pixel, pbrt-v4's least
/// (Camera::Approximate_dp_dxy), over which samples are spread anyway.
inline float camera_spread_rad(float pixel_angle_rad) { return 0.125F * pixel_angle_rad; }

/// How much a scattered ray widens: a two-hundredth of the cone that holds as much solid angle as
/// one sample stands for. A number, or lanes of them.
template <typename Number>
inline Number scattered_spread_rad(const Number& pdf) {
  constexpr float widest_rad = 0.02F;
  return smaller(0.005F / square_root(pdf), widest_rad);
}

/// The radiance of a path with values that are not finite.
inline constexpr Rgb not_a_number(std::numeric_limits<float>::quiet_NaN());

/// What is left of light after some metres, which may be infinitely many.
inline Rgb transmittance(const Rgb& absorption_per_m, float distance_m) {
  const auto left = [&](float absorption) {
    return absorption > 0.0F ? std::exp(-absorption * distance_m) : 1.0F;
  };
  return {left(absorption_per_m.r), left(absorption_per_m.g), left(absorption_per_m.b)};
}

}  // namespace foveola
