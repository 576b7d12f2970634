// Directional lights: from one direction exactly, or from a disc in the sky that rays see.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_choice.h"
#include "renderer/trace/lights/light_sampling.h"

namespace foveola {

/// The directional ones among a scene's lights, drawn by their irradiance E, or all alike. A disc
/// of angular radius a shines with E / (pi sin^2 a), so that a surface that faces its centre gets
/// E. Radii above a right angle count as one, and below 5e-4 rad (a tenth of the Sun's) as none: a
/// direction of floats cannot decide whether it is in the disc. Lights that are not finite or do
/// not shine are left out.
class Suns {
 public:
  explicit Suns(const Scene& scene, LightSelection selection = LightSelection::usual);

  bool empty() const { return suns_.empty(); }
  std::size_t size() const { return suns_.size(); }
  /// Those without a disc.
  std::size_t sizeless() const;

  /// The luminous irradiance of a surface that faces all of them.
  double irradiance() const { return irradiance_; }

  struct Sample {
    std::size_t sun;
    Vec3 direction;  ///< unit length, towards the light
    bool is_delta;
    float probability;  ///< with which a delta sun was drawn
    Rgb irradiance;     ///< that a delta sun gives
  };
  /// u_choice, u: in the unit square. Not to be called when empty().
  Sample sample(const Vec2& u_choice, const Vec2& u) const;

  /// Light of the discs in `direction`. known: a sun from which the direction was drawn, if any, so
  /// that rounding at its disc's rim does not matter.
  DistantLight at(const Vec3& direction, std::optional<std::size_t> known = {}) const;

 private:
  struct Sun {
    Rgb irradiance;
    DirectionCone disc;
    bool is_delta;
    float probability;   ///< with which it is drawn
    DistantLight shine;  ///< what its disc gives; nothing for a delta sun

    explicit Sun(const PunctualLight& light);
    bool covers(const Vec3& direction) const;
  };

  std::vector<Sun> suns_;
  std::optional<AliasTable> choice_;
  double irradiance_ = 0.0;
};

}  // namespace foveola
