#include "renderer/trace/triangle_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/opacity.h"
#include "renderer/trace/surface.h"

namespace foveola {
namespace {

/// A triangle is near if its longest side, squared, is more than this share of the squared distance
/// to its nearest corner. Points that are uniform in the area of the others are cheaper. Against a
/// tenth of this share, the variance of the built-in scenes rises by 1 to 4 %, and their time falls
/// by 5 to 18 %.
constexpr float near_share = 1.0F;

/// In steradians; triangles with less are seen edge-on, and give next to nothing.
constexpr float smallest_solid_angle = 1e-3F;

/// The mean over the texels, or over a grid of 1024 of them a side, so that small bright spots are
/// not missed.
Rgb mean_colour(const Texture& texture) {
  const int width = std::min(texture.width(), 1024);
  const int height = std::min(texture.height(), 1024);
  DVec3 sum(0.0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      sum += DVec3(texture.sample({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5F) / static_cast<float>(height)}));
    }
  }
  return Rgb(sum / static_cast<double>(width * height));
}

bool shines(const Material& material) { return material.is_emissive() || material.unlit; }

/// The mean luminance that each material's surface shines with; 0 for those that are not sampled.
std::vector<float> mean_radiance_of_materials(const Scene& scene) {
  std::vector<std::optional<Rgb>> means(scene.textures.size());
  std::vector<float> radiance;
  for (const Material& material : scene.materials) {
    if (!material.is_emissive() || material.unlit) {
      radiance.push_back(0.0F);
      continue;
    }
    Rgb mean(1.0F);
    if (material.emissive_texture.exists()) {
      const auto texture = static_cast<std::size_t>(material.emissive_texture.texture);
      if (!means[texture]) {
        means[texture] = mean_colour(scene.textures[texture]);
      }
      mean = *means[texture];
    }
    radiance.push_back(luminance(material.emission * mean));
  }
  return radiance;
}

/// Uniform barycentric coordinates (Heitz 2019, "A Low-Distortion Map Between Triangle and
/// Square"). Points, or lanes of them.
template <typename Point>
Point sample_barycentric(const Point& u) {
  const auto is_upper = u.x < u.y;
  return {chosen(is_upper, 0.5F * u.x, u.x - 0.5F * u.y),
          chosen(is_upper, u.y - 0.5F * u.x, 0.5F * u.y)};
}

/// The squared distance between two points, or lanes of them.
template <typename Vector>
auto squared_distance(const Vector& a, const Vector& b) {
  return dot(a - b, a - b);
}

/// The density per steradian of a point drawn uniformly in the solid angle, or in the area where
/// the solid angle is 0. distance: of the point. cosine: between the triangle's normal and the way
/// to it.
template <typename Number>
Number density(const Number& solid_angle, const Number& area, const Number& distance,
               const Number& cosine) {
  const Number in_area =
      smaller(distance * distance / (area * cosine), std::numeric_limits<float>::max());
  return chosen(solid_angle > 0.0F, 1.0F / solid_angle, in_area);
}

/// An emissive triangle, or eight, each with the place that its light is for.
template <typename Number>
class SeenEmitterOf {
 public:
  using Vector = Vec3Of<Number>;

  SeenEmitterOf(const EmitterOf<Number>& emitter, const Vector& place)
      : emitter_(emitter),
        place_(place),
        height_over_plane_(dot(emitter.front_normal, place - emitter.triangle.p0)) {}

  MaskOf<Number> shines() const {
    return (height_over_plane_ > 0.0F) | ((height_over_plane_ < 0.0F) & emitter_.is_two_sided);
  }

  MaskOf<Number> is_near() const {
    const TriangleOf<Number>& triangle = emitter_.triangle;
    const Number nearest = smaller(
        squared_distance(triangle.p0, place_),
        smaller(squared_distance(triangle.p1, place_), squared_distance(triangle.p2, place_)));
    return emitter_.squared_longest_side > near_share * nearest;
  }

  /// A point of the triangle without its radiance. solid_angle: of the triangle, if the point was
  /// drawn uniformly in it, else 0.
  LocalLightSampleOf<Number> at(const Vec2Of<Number>& barycentric,
                                const Number& solid_angle) const {
    const Vector to_point = emitter_.triangle.at(barycentric) - place_;
    const Number distance = square_root(dot(to_point, to_point));
    const Number height = magnitude(dot(emitter_.front_normal, to_point));
    // Off the triangle on the side of the place, but never past the place.
    const Number off =
        with_sign(smaller(emitter_.rounding_error, 0.5F * height), height_over_plane_);
    const Number pdf = density(solid_angle, emitter_.area, distance, height / distance);
    return {.to_light = to_point + off * emitter_.front_normal,
            .pdf = chosen(height > 0.0F, pdf, Number{})};
  }

 private:
  const EmitterOf<Number>& emitter_;
  Vector place_;
  Number height_over_plane_;
};

}  // namespace

TriangleLights::TriangleLights(const Scene& scene, bool by_area)
    : scene_(scene),
      first_of_object_(scene.object_count(), nothing),
      radiance_of_object_(scene.object_count(), 0.0F) {
  const std::vector<float> radiance = mean_radiance_of_materials(scene);
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    const Mesh& mesh = scene.mesh_of(object);
    const auto material = static_cast<std::size_t>(mesh.material);
    if (is_invisible(scene, mesh) || !shines(material_of(scene, mesh))) {
      continue;
    }
    if (radiance[material] > 0.0F && emitters_.size() + mesh.triangles.size() <= most_triangles) {
      radiance_of_object_[object] = radiance[material];
      add_object(object, by_area);
    } else {
      has_unlisted_ = true;
    }
  }
}

void TriangleLights::add_object(std::uint32_t object, bool by_area) {
  first_of_object_[object] = static_cast<std::uint32_t>(emitters_.size());
  const Mesh& mesh = scene_.mesh_of(object);
  const Material& material = material_of(scene_, mesh);
  const bool is_textured = material.emissive_texture.exists() && !mesh.uv_sets.empty();
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    const Triangle triangle(scene_, object, t);
    const float squared_longest_side = std::max({squared_distance(triangle.p0, triangle.p1),
                                                 squared_distance(triangle.p1, triangle.p2),
                                                 squared_distance(triangle.p2, triangle.p0)});
    emitters_.push_back(
        {EmitterOf<float>{.triangle = triangle,
                          .front_normal = triangle.front_normal(),
                          .area = static_cast<float>(triangle.area()),
                          .squared_longest_side = by_area ? 0.0F : squared_longest_side,
                          .rounding_error = triangle.rounding_error(),
                          .is_two_sided = material.double_sided},
         /*is_uniform=*/!is_textured && !has_opacity(scene_, mesh), material.emission, object, t});
  }
}

double TriangleLights::power(std::size_t triangle) const {
  const Emitter& emitter = emitters_[triangle];
  const int sides = emitter.is_two_sided ? 2 : 1;
  const double power = sides * std::numbers::pi * static_cast<double>(emitter.area) *
                       radiance_of_object_[emitter.object];
  return power > 0.0 && std::isfinite(power) && is_finite(emitter.front_normal) ? power : 0.0;
}

LightBounds TriangleLights::bounds(std::size_t triangle) const {
  if (!(power(triangle) > 0.0)) {
    return {};
  }
  const Emitter& emitter = emitters_[triangle];
  const TriangleOf<float>& corners = emitter.triangle;
  return {.box = {.lower = glm::min(corners.p0, glm::min(corners.p1, corners.p2)),
                  .upper = glm::max(corners.p0, glm::max(corners.p1, corners.p2))},
          .axis = DVec3(emitter.front_normal),
          .spread_rad = 0.0,
          .falloff_rad = 0.5 * std::numbers::pi,
          .two_sided = emitter.is_two_sided,
          .intensity = static_cast<double>(emitter.area) * radiance_of_object_[emitter.object]};
}

std::optional<SphericalTriangle> TriangleLights::seen_from_near(const Emitter& emitter,
                                                                const Vec3& place) {
  if (!SeenEmitterOf<float>(emitter, place).is_near()) {
    return std::nullopt;
  }
  const SphericalTriangle seen(emitter.triangle, place);
  return seen.solid_angle() > smallest_solid_angle ? std::optional(seen) : std::nullopt;
}

std::optional<LocalLightSample> TriangleLights::sample(std::size_t triangle, const Vec3& place,
                                                       const Vec2& u) const {
  const Emitter& emitter = emitters_[triangle];
  const SeenEmitterOf<float> seen_emitter(emitter, place);
  if (!seen_emitter.shines()) {
    return std::nullopt;
  }
  const auto seen = seen_from_near(emitter, place);
  const Vec2 barycentric = seen ? seen->sample(u) : sample_barycentric(u);
  const Mesh& mesh = scene_.mesh_of(emitter.object);
  const float opaque = opacity(scene_, mesh, emitter.index, barycentric);
  if (!(opaque > 0.0F)) {
    return std::nullopt;
  }
  LocalLightSample sample = seen_emitter.at(barycentric, seen ? seen->solid_angle() : 0.0F);
  if (sample.pdf == 0.0F) {
    return std::nullopt;
  }
  sample.radiance = opaque * emitted_radiance(scene_, mesh, emitter.index, barycentric);
  return sample;
}

float TriangleLights::pdf(std::size_t triangle, const Vec3& place, float distance,
                          float cosine) const {
  const Emitter& emitter = emitters_[triangle];
  if (!(distance > 0.0F && cosine > 0.0F && emitter.area > 0.0F)) {
    return 0.0F;
  }
  const auto seen = seen_from_near(emitter, place);
  return density(seen ? seen->solid_angle() : 0.0F, emitter.area, distance, cosine);
}

void TriangleLights::Drawn::put(std::size_t lane, const TriangleLights& lights,
                                std::size_t triangle, float probability) {
  const Emitter& emitter = lights.emitters_[triangle];
  emitters_[lane] = &emitter;
  p0_.put(lane, emitter.triangle.p0);
  p1_.put(lane, emitter.triangle.p1);
  p2_.put(lane, emitter.triangle.p2);
  front_normal_.put(lane, emitter.front_normal);
  radiance_.put(lane, emitter.radiance);
  area_[lane] = emitter.area;
  squared_longest_side_[lane] = emitter.squared_longest_side;
  rounding_error_[lane] = emitter.rounding_error;
  is_two_sided_[lane] = emitter.is_two_sided ? 1.0F : 0.0F;
  probability_[lane] = probability;
}

EmitterOf<Floats> TriangleLights::Drawn::emitters() const {
  EmitterOf<Floats> emitters{};
  emitters.triangle.p0 = p0_.load();
  emitters.triangle.p1 = p1_.load();
  emitters.triangle.p2 = p2_.load();
  emitters.front_normal = front_normal_.load();
  emitters.area = area_.load();
  emitters.squared_longest_side = squared_longest_side_.load();
  emitters.rounding_error = rounding_error_.load();
  emitters.is_two_sided = is_two_sided_.load() > 0.0F;
  return emitters;
}

TriangleLights::Drawn::Samples TriangleLights::Drawn::sample(const Vec3s& place,
                                                             const Vec2s& u) const {
  const EmitterOf<Floats> emitters = this->emitters();
  const SeenEmitterOf<Floats> seen(emitters, place);
  const LaneMask shines = seen.shines();
  const LaneMask is_near = shines & seen.is_near();
  Vec2s barycentric = sample_barycentric(u);
  Floats solid_angle{};
  if (any_lane(is_near)) {
    sample_near(place, u, is_near, barycentric, solid_angle);
  }
  Samples samples = seen.at(barycentric, solid_angle);
  samples.pdf = shines ? probability_.load() * samples.pdf : Floats{};
  samples.radiance = radiance_.load();
  return samples;
}

void TriangleLights::Drawn::sample_near(const Vec3s& place, const Vec2s& u, const LaneMask& lanes,
                                        Vec2s& barycentric, Floats& solid_angle) const {
  for_each_lane(lanes, [&](std::size_t lane) {
    const Vec3 here(place.x[lane], place.y[lane], place.z[lane]);
    if (const auto seen = seen_from_near(*emitters_[lane], here)) {
      const Vec2 drawn = seen->sample({u.x[lane], u.y[lane]});
      barycentric.x[lane] = drawn.x;
      barycentric.y[lane] = drawn.y;
      solid_angle[lane] = seen->solid_angle();
    }
  });
}

}  // namespace foveola
