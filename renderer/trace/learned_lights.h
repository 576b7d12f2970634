// Which lights reach which part of a scene, learned from paths that were traced before: walls are
// in no other way known to next-event estimation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/light_tree.h"
#include "renderer/trace/shading_point.h"
#include "renderer/trace/square_warp.h"
#include "renderer/trace/surface_regions.h"

namespace foveola {

enum class LightKind : std::uint8_t { environment, suns, local, nothing };

/// With which probability each kind is drawn; 0 for those that there are not.
struct KindProbabilities {
  float environment = 0.0F;
  float suns = 0.0F;
  float local = 0.0F;
};

/// How a light sample at a path's vertex turned out, before anything was learned.
struct LightOutcome {
  ShadingPoint shading_point;
  LightKind kind;
  /// Of the environment the square of SquareWarp that the direction was drawn from; of local lights
  /// the one drawn, or `no_light`.
  std::uint32_t light;
  /// What arrived of it, in units of the radiance that the path scatters to where it comes from.
  float gain = 0.0F;

  static constexpr std::uint32_t no_light = ~0U;
};

/// Tables for the regions of the surfaces that paths have met; in parts of the scene that they have
/// not, those of some region near them. Whatever was learned, every light keeps a part of the
/// probability that it usually has, so that what is wrong costs samples and never makes a picture
/// wrong.
class LearnedLights {
 public:
  /// Nothing is learned: one region.
  explicit LearnedLights(const KindProbabilities& usual) : kinds_(1, usual) {}

  /// usual: that the outcomes were drawn with. tree: of the local lights, or null. knows_sky: the
  /// environment was drawn by its brightness.
  LearnedLights(std::span<const LightOutcome> outcomes, const KindProbabilities& usual,
                const LightTree* tree, bool knows_sky);

  /// The mean square of light samples drawn as learned, over that of those drawn as usual, as far
  /// as these outcomes tell, from which nothing should have been learned; 1 where nothing arrived.
  double relative_mean_square(std::span<const LightOutcome> outcomes,
                              const KindProbabilities& usual, const LightTree* tree) const;

  std::uint32_t region_of(const Vec3& position, const Vec3& normal) const {
    return regions_.count() == 1 ? 0 : regions_.region_of({position, normal});
  }
  Uints regions_of(const Vec3s& position, const Vec3s& normal) const {
    return regions_.count() == 1 ? Uints{} : regions_.regions_of(position, normal);
  }

  const KindProbabilities& kinds(std::uint32_t region) const { return kinds_[region]; }
  /// The density of directions to the environment in the unit square of its numbers; null:
  /// constant.
  const SquareWarp* sky(std::uint32_t region) const {
    return sky_.empty() ? nullptr : &sky_[region];
  }
  /// Null: none.
  const LightTree::Preferences* preferences(std::uint32_t region) const {
    return preferences_.empty() ? nullptr : &preferences_[region];
  }

 private:
  /// With which probability the outcome's light was drawn, over that with which it is drawn now.
  double relative_probability(const LightOutcome& outcome, const KindProbabilities& usual,
                              const LightTree* tree) const;

  SurfaceRegions regions_;
  std::vector<KindProbabilities> kinds_;
  std::vector<SquareWarp> sky_;
  std::vector<LightTree::Preferences> preferences_;
};

}  // namespace foveola
