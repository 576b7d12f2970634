// Emissive triangles of meshes and instances as light sources, sampled by the solid angle that they
// subtend at a point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "renderer/base/numbers/lanes.h"
#include "renderer/base/turns.h"
#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/coincident_surfaces.h"
#include "renderer/trace/lights/light_bounds.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/rays/ray_scene.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {

/// A triangle seen from a point, one per lane or a single one: Number is float or Floats. Vectors
/// are doubles, since a needle's angles are differences of nearly equal vectors. Results have a
/// float's precision.
template <typename Number>
class SphericalTriangleOf {
 public:
  /// Seen from `viewpoint`. All results are finite for every finite triangle and viewpoint.
  SphericalTriangleOf(const TriangleOf<Number>& triangle, const Vec3Of<Number>& viewpoint)
      : a_(wide(triangle.p0) - wide(viewpoint)),
        b_(wide(triangle.p1) - wide(viewpoint)),
        c_(wide(triangle.p2) - wide(viewpoint)),
        normal_(cross(b_ - a_, c_ - a_)),
        length_a_(length(a_)),
        length_b_(length(b_)),
        length_c_(length(c_)) {
    const Wide numerator = magnitude(dot(normal_, a_));
    const Wide denominator = length_a_ * length_b_ * length_c_ + dot(a_, b_) * length_c_ +
                             dot(b_, c_) * length_a_ + dot(c_, a_) * length_b_;
    half_turns_ = turns_of(narrow(numerator), narrow(denominator));
  }

  /// In steradians, in [0, 2 pi]; ambiguous between the two in the triangle's plane (Van Oosterom
  /// and Strackee 1983, "The Solid Angle of a Plane Triangle").
  Number solid_angle() const { return (4.0F * std::numbers::pi_v<float>)*half_turns_; }

  /// The barycentric coordinates of a point whose direction is uniform in the solid angle (as Arvo
  /// 1995, "Stratified Sampling of Spherical Triangles", but with Peters' formula for the divided
  /// side: 2021, "BRDF Importance Sampling for Polygonal Lights"). u: in the unit square. The solid
  /// angle must not be 0.
  Vec2Of<Number> sample(const Vec2Of<Number>& u) const {
    const Vector a = (1.0 / length_a_) * a_;
    const Vector b = (1.0 / length_b_) * b_;
    const Vector c = (1.0 / length_c_) * c_;
    // The corner d on the side from a to c such that (a, b, d) has the share u.x of the solid
    // angle. It mirrors a at an axis between a and c, x a + y c. The solid angle's formula, with d
    // in place of c, is linear in x and y.
    const Wide triple = magnitude(dot(normal_, a)) / (length_b_ * length_c_);
    const SinesCosines<Number> half_angle = sine_cosine_of_turns(Number(u.x * half_turns_));
    const Wide sine = wide(half_angle.sine);
    const Wide cosine = wide(half_angle.cosine);
    const Vector axis =
        (cosine * triple - sine * dot(a + b, c)) * a + (sine * (1.0 + dot(a, b))) * c;
    const Wide squared_length = dot(axis, axis);
    const auto has_axis = squared_length > 0.0;
    const Wide twice = 2.0 * dot(axis, a) / (has_axis ? squared_length : Wide{} + 1.0);
    const Vector mirrored = twice * axis - a;
    const Vector d{has_axis ? mirrored.x : c.x, has_axis ? mirrored.y : c.y,
                   has_axis ? mirrored.z : c.z};

    // On the arc from b to d, uniform in height over b.
    const Wide lowest = dot(d, b);
    const Wide height = 1.0 - wide(u.y) * (1.0 - lowest);
    const Wide squared_sine = 1.0 - lowest * lowest;
    const auto has_sine = squared_sine > 0.0;
    const Wide above = 1.0 - height * height;
    const Wide squared_along =
        (above > 0.0 ? above : Wide{}) / (has_sine ? squared_sine : Wide{} + 1.0);
    const Wide along = has_sine ? square_root(squared_along) : Wide{};
    return barycentric_of((height - along * lowest) * b + along * d);
  }

 private:
  using Wide = WideOf<Number>;
  struct Vector {
    Wide x, y, z;

    friend Vector operator+(const Vector& a, const Vector& b) {
      return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
      return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(const Wide& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
    friend Wide dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Vector cross(const Vector& a, const Vector& b) {
      return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
    }
    friend Wide length(const Vector& v) { return square_root(dot(v, v)); }
  };

  static Vector wide(const Vec3Of<Number>& v) {
    return {foveola::wide(v.x), foveola::wide(v.y), foveola::wide(v.z)};
  }
  static Wide wide(const Number& x) { return foveola::wide(x); }
  static Wide in_unit_interval(const Wide& x, const Wide& most) {
    const Wide above = x > 0.0 ? x : Wide{};
    return above < most ? above : most;
  }

  Vec2Of<Number> barycentric_of(const Vector& direction) const {
    // Cramer's rule for direction * t = a + x * (b - a) + y * (c - a), times the determinant.
    const Wide determinant = dot(direction, normal_);
    const auto is_parallel = determinant == 0.0;
    const Wide inverse = 1.0 / (is_parallel ? Wide{} + 1.0 : determinant);
    const Vector moment = cross(a_, direction);
    const Wide x = in_unit_interval(dot(c_ - a_, moment) * inverse, Wide{} + 1.0);
    const Wide y = in_unit_interval(-dot(b_ - a_, moment) * inverse, 1.0 - x);
    const Wide third = Wide{} + 1.0 / 3.0;
    return {narrow(is_parallel ? third : x), narrow(is_parallel ? third : y)};
  }

  Vector a_, b_, c_;  ///< corners, relative to the viewpoint
  Vector normal_;     ///< length: twice the area
  Wide length_a_, length_b_, length_c_;
  Number half_turns_;  ///< half the solid angle, in turns
};
using SphericalTriangle = SphericalTriangleOf<float>;

/// Data for sampling a point of an emissive triangle, or of eight. Number: float, or Floats.
template <typename Number>
struct EmitterOf {
  TriangleOf<Number> triangle;
  Vec3Of<Number> front_normal;
  Number area;                  ///< square metres
  Number squared_longest_side;  ///< square metres; 0: never sampled by solid angle
  Number rounding_error;        ///< see TriangleOf
  Number shining_sides;         ///< number of emitting sides: 1 or 2
  Vec3Of<Number> radiance;      ///< without textures
};

/// A list of triangles in world space. Triangles that are near for their size are sampled uniformly
/// in solid angle, others in area. A textured emitter counts with its texture's mean, a transparent
/// one as opaque.
///
/// Emission left out of the list: unlit materials, textures with a black mean, and objects beyond
/// `max_triangles`. Their light is sampled by rays alone.
class TriangleLights {
 public:
  static constexpr std::size_t max_triangles = 4'000'000;
  static constexpr std::uint32_t nothing = ~0U;

  /// The scene must outlive this object. by_area: samples all triangles uniformly in area.
  explicit TriangleLights(const Scene& scene, bool by_area = false);

  std::size_t size() const { return emitters_.size(); }

  /// Resolves coincident triangles: which is visible and emits.
  const CoincidentSurfaces& coincident() const { return *coincident_; }

  /// Whether some emission is not in the list.
  bool has_unlisted() const { return has_unlisted_; }

  /// Luminous power in radiance times square metre times steradian; 0 for triangles without area or
  /// with non-finite values.
  double power(std::size_t triangle) const;
  LightBounds bounds(std::size_t triangle) const;

  /// A point of the triangle; nullopt if it does not emit towards `place`. u: in the unit square.
  std::optional<LocalLightSample> sample(std::size_t triangle, const Vec3& place,
                                         const Vec2& u) const;

  /// Collects triangles, then samples a point of each at once.
  class Drawn;

  /// Density of sample() per steradian at `place`, for a point at `distance` in metres, with
  /// `cosine` between its direction and the triangle's normal.
  float pdf(std::size_t triangle, const Vec3& place, float distance, float cosine) const;

  /// The index of the triangle that a ray hit, or `nothing` if it is not in the list.
  std::uint32_t index_of(const Hit& hit) const {
    const std::uint32_t first = first_of_object_[hit.object];
    return first == nothing ? nothing : first + hit.triangle;
  }

 private:
  struct Emitter : EmitterOf<float> {
    bool is_uniform;  ///< same `radiance` everywhere and in all directions
    SceneTriangle place;
  };

  /// The triangle seen from `place`; nullopt if it is not to be sampled by solid angle.
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

  /// Whether this class can sample the triangle: it has a single radiance. The others are left to
  /// TriangleLights::sample().
  static bool can_draw(const TriangleLights& lights, std::size_t triangle) {
    return lights.emitters_[triangle].is_uniform;
  }

  /// Sets the triangle chosen in a lane, with its probability.
  void put(std::size_t lane, const TriangleLights& lights, std::size_t triangle,
           float probability) {
    emitters_[lane] = &lights.emitters_[triangle];
    probability_[lane] = probability;
  }

  using Samples = LocalLightSampleOf<Floats>;
  /// place: the shading points. u: in the unit square.
  Samples sample(const Vec3s& place, const Vec2s& u) const;

 private:
  EmitterOf<Floats> emitters() const;

  std::array<const Emitter*, lane_count> emitters_;
  FloatLanes probability_{};
};

}  // namespace foveola
