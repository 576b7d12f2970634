// Emissive triangles as light sources: those of meshes and of every instance of a mesh.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/base/lanes.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/coincident_surfaces.h"
#include "renderer/trace/light_bounds.h"
#include "renderer/trace/local_light_sample.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/spherical_triangle.h"
#include "renderer/trace/triangle.h"

namespace foveola {

/// What drawing a point needs of an emissive triangle, or of eight. Number: float, or Floats.
template <typename Number>
struct EmitterOf {
  TriangleOf<Number> triangle;
  Vec3Of<Number> front_normal;
  Number area;                  ///< square metres
  Number squared_longest_side;  ///< square metres; 0: points are never uniform in solid angle
  Number rounding_error;        ///< see TriangleOf
  Number shining_sides;         ///< 1 or 2
  Vec3Of<Number> radiance;      ///< without textures
};

/// A list of triangles in world space. Points are drawn uniformly in the solid angle of triangles
/// that are near for their size, and in the area of the others. A textured emitter counts with its
/// texture's mean, and what is not opaque as if it were.
///
/// Not in the list, though they shine: unlit materials, textures whose mean is black, and objects
/// that would make it longer than `most_triangles`. Rays find their light, without help.
class TriangleLights {
 public:
  static constexpr std::size_t most_triangles = 4'000'000;
  static constexpr std::uint32_t nothing = ~0U;

  /// The scene must outlive this object. by_area: points are uniform in the area of all triangles.
  explicit TriangleLights(const Scene& scene, bool by_area = false);

  std::size_t size() const { return emitters_.size(); }

  /// Which of several triangles in one place is seen, and lights.
  const CoincidentSurfaces& coincident() const { return *coincident_; }

  /// Whether something shines that is not in the list.
  bool has_unlisted() const { return has_unlisted_; }

  /// Luminous power in radiance times square metre times steradian; 0 for triangles without area
  /// and for those that are not finite.
  double power(std::size_t triangle) const;
  LightBounds bounds(std::size_t triangle) const;

  /// A point of the triangle; empty if it does not shine towards `place`. u: in the unit square.
  std::optional<LocalLightSample> sample(std::size_t triangle, const Vec3& place,
                                         const Vec2& u) const;

  /// Gathers triangles, and then draws a point of each at once.
  class Drawn;

  /// With which density per steradian at `place` sample() would have drawn a point at the given
  /// distance in metres, seen at an angle to the triangle's normal of the given cosine.
  float pdf(std::size_t triangle, const Vec3& place, float distance, float cosine) const;

  /// The triangle that a ray hit, or `nothing` if it is not in the list.
  std::uint32_t index_of(const Hit& hit) const {
    const std::uint32_t first = first_of_object_[hit.object];
    return first == nothing ? nothing : first + hit.triangle;
  }

 private:
  struct Emitter : EmitterOf<float> {
    bool is_uniform;  ///< shines with `radiance` everywhere and in all directions
    SceneTriangle place;
  };

  /// The triangle seen from `place`, if it is to be sampled by its solid angle.
  static std::optional<SphericalTriangle> seen_from_near(const Emitter& emitter, const Vec3& place);

  void add_object(std::uint32_t object, bool by_area);
  void heed_coincidence();

  const Scene& scene_;
  std::vector<Emitter> emitters_;
  std::vector<std::uint32_t> first_of_object_;
  std::vector<float> radiance_of_object_;  ///< mean luminance
  std::optional<CoincidentSurfaces> coincident_;
  bool has_unlisted_ = false;
};

class TriangleLights::Drawn {
 public:
  explicit Drawn(const TriangleLights& lights) { emitters_.fill(lights.emitters_.data()); }

  /// Whether the triangle's points can be drawn here: it shines with one radiance. The others are
  /// left to TriangleLights::sample().
  static bool can_draw(const TriangleLights& lights, std::size_t triangle) {
    return lights.emitters_[triangle].is_uniform;
  }

  /// The triangle that was chosen in a lane, with the probability of that choice.
  void put(std::size_t lane, const TriangleLights& lights, std::size_t triangle,
           float probability) {
    emitters_[lane] = &lights.emitters_[triangle];
    probability_[lane] = probability;
  }

  using Samples = LocalLightSampleOf<Floats>;
  /// place: that the light is for. u: in the unit square.
  Samples sample(const Vec3s& place, const Vec2s& u) const;

 private:
  EmitterOf<Floats> emitters() const;

  std::array<const Emitter*, lane_count> emitters_;
  FloatLanes probability_{};
};

}  // namespace foveola
