// Directional lights: delta lights, or discs in the sky that rays see.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_choice.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The directional lights of a scene, drawn by their irradiance E, or uniformly. A disc of angular
/// radius a has radiance E / (pi sin^2 a), so that a surface facing its centre gets E. Radii above
/// a right angle are clamped to it. Radii below 5e-4 rad (a tenth of the Sun's) count as 0, since a
/// direction of floats cannot resolve such a disc. Lights with non-finite values or without
/// emission are left out.
class Suns {
 public:
  explicit Suns(const Scene& scene, LightSelection selection = LightSelection::usual);

  bool empty() const { return suns_.empty(); }
  std::size_t size() const { return suns_.size(); }
  /// Number of suns without a disc.
  std::size_t sizeless() const;

  /// Luminous irradiance of a surface facing all suns.
  double irradiance() const { return irradiance_; }

  struct Sample {
    std::size_t sun;
    Vec3 direction;  ///< unit length, towards the light
    bool is_delta;
    float probability;  ///< of drawing this sun, if a delta light
    Rgb irradiance;     ///< of a delta light
  };
  /// u_choice, u: in the unit square. Not to be called when empty().
  Sample sample(const Vec2& u_choice, const Vec2& u) const;

  /// Light of the discs in `direction`. known: the sun that the direction was drawn from, if any,
  /// which counts despite rounding at its disc's rim.
  DistantLight at(const Vec3& direction, std::optional<std::size_t> known = {}) const;

 private:
  struct Sun {
    Rgb irradiance;
    DirectionCone disc;
    bool is_delta;
    float probability;   ///< of drawing it
    DistantLight shine;  ///< radiance and density of its disc; none for a delta light

    explicit Sun(const PunctualLight& light);
    bool covers(const Vec3& direction) const;
  };

  std::vector<Sun> suns_;
  std::optional<AliasTable> choice_;
  double irradiance_ = 0.0;
};

}  // namespace foveola
