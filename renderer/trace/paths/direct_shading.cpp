#include "renderer/trace/paths/direct_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/trace/paths/vertex_rules.h"
#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/opacity.h"
#include "renderer/trace/surfaces/surface.h"

namespace foveola {
namespace {

/// A surface's own colour, and its transmittance.
struct Layer {
  Rgb color{0.0F};
  Rgb passes{0.0F};
};

/// The colour scaled so that no channel exceeds 1, which keeps its hue.
Rgb limited(const Rgb& color) { return color / std::max(1.0F, max_component(color)); }

Rgb lit(const SurfacePoint& point, const Vec3& direction) {
  const float cosine = -glm::dot(point.shading_normal, direction);
  return point.reflectance.base_color * (direct_ambient + (1.0F - direct_ambient) * cosine);
}

/// Share of light transmitted straight.
float transmission(const Material& material, const Reflectance& reflectance) {
  return is_thin_transmissive(material) ? reflectance.transmission * (1.0F - reflectance.metallic)
                                        : 0.0F;
}

Layer opaque_layer(const Scene& scene, const Hit& hit, const Vec3& direction,
                   float pixel_angle_rad) {
  const Material& material = material_of(scene, scene.mesh_of(hit.object));
  if (material.unlit) {
    return {.color = limited(unlit_color(scene, hit))};
  }
  const SurfacePoint point = surface_point(scene, hit, direction, pixel_angle_rad * hit.t);
  const float passing = transmission(material, point.reflectance);
  const Rgb shown =
      limited(lit(point, direction) + surface_emission(scene, hit, direction).radiance);
  return {.color = (1.0F - passing) * shown, .passes = passing * point.reflectance.base_color};
}

float opacity_at(const Scene& scene, const Hit& hit) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  return has_opacity(scene, mesh) ? opacity(scene, mesh, hit.triangle, hit.barycentric) : 1.0F;
}

Layer layer(const Scene& scene, const Hit& hit, const Vec3& direction, float pixel_angle_rad) {
  const float opaque = opacity_at(scene, hit);
  const Layer whole = opaque_layer(scene, hit, direction, pixel_angle_rad);
  return {.color = opaque * whole.color, .passes = opaque * whole.passes + (1.0F - opaque)};
}

}  // namespace

Rgb direct_color(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                 const Vec3& direction, float pixel_angle_rad) {
  Rgb color(0.0F);
  Rgb passed(1.0F);
  Ray ray{.origin = viewpoint, .direction = direction};
  for (int layers = 0; layers < max_thin_surfaces && passed != Rgb(0.0F); ++layers) {
    const Hit hit = rays.closest_hit_of_any_opacity(ray);
    if (hit.missed()) {
      return color + passed * direct_background;
    }
    const Layer next = layer(scene, hit, direction, pixel_angle_rad);
    color += passed * next.color;
    passed *= next.passes;
    ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
  }
  return color;
}

}  // namespace foveola
