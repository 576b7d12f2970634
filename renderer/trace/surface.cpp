#include "renderer/trace/surface.h"

#include <cmath>

#include "renderer/trace/triangle.h"

namespace foveola {
namespace {

const Material& material_of(const Scene& scene, const Mesh& mesh) {
  return scene.materials[static_cast<std::size_t>(mesh.material)];
}

/// The texture's value, or white where the material has none.
Vec4 texture_value(const Scene& scene, const TextureUse& use, const Vec2& uv) {
  return use.exists() ? scene.textures[static_cast<std::size_t>(use.texture)].sample(uv)
                      : Vec4(1.0F);
}

Vec2 texture_coordinate(const Mesh& mesh, std::uint32_t triangle, const Vec2& barycentric) {
  return mesh.uv_sets.empty() ? Vec2(0.0F)
                              : interpolate(mesh.uv_sets[0], mesh.triangles[triangle], barycentric);
}

Reflectance reflectance_at(const Scene& scene, const Mesh& mesh, const Hit& hit) {
  const Material& material = material_of(scene, mesh);
  Reflectance reflectance{.base_color = material.base_color,
                          .metallic = material.metallic,
                          .roughness = material.roughness};
  if (!material.base_color_texture.exists() && !material.metallic_roughness_texture.exists()) {
    return reflectance;
  }
  const Vec2 uv = texture_coordinate(mesh, hit.triangle, hit.barycentric);
  const Vec4 metallic_roughness = texture_value(scene, material.metallic_roughness_texture, uv);
  reflectance.base_color *= Rgb(texture_value(scene, material.base_color_texture, uv));
  reflectance.roughness *= metallic_roughness.g;
  reflectance.metallic *= metallic_roughness.b;
  return reflectance;
}

/// The interpolated normal on the side of `geometric_normal`, or that one itself where the
/// interpolated one has no direction or is turned away from `outgoing`.
Vec3 shading_normal_at(const Mesh& mesh, const Hit& hit, const Vec3& geometric_normal,
                       const Vec3& outgoing) {
  if (mesh.normals.empty()) {
    return geometric_normal;
  }
  Vec3 normal = interpolate(mesh.normals, mesh.triangles[hit.triangle], hit.barycentric);
  const float squared_length = glm::dot(normal, normal);
  if (!(squared_length > 0.0F)) {
    return geometric_normal;
  }
  normal *= std::copysign(1.0F / std::sqrt(squared_length), glm::dot(normal, geometric_normal));
  return glm::dot(normal, outgoing) > 0.0F ? normal : geometric_normal;
}

}  // namespace

SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  const Triangle triangle(mesh, hit.triangle);
  const Vec3 front_normal = triangle.front_normal();
  const Vec3 geometric_normal =
      glm::dot(front_normal, direction) > 0.0F ? -front_normal : front_normal;
  return {.origin = triangle.at(hit.barycentric) + triangle.rounding_error() * geometric_normal,
          .geometric_normal = geometric_normal,
          .shading_normal = shading_normal_at(mesh, hit, geometric_normal, -direction),
          .reflectance = reflectance_at(scene, mesh, hit)};
}

Rgb emitted_radiance(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
                     const Vec2& barycentric) {
  const Material& material = material_of(scene, mesh);
  if (!material.emissive_texture.exists()) {
    return material.emission;
  }
  const Vec2 uv = texture_coordinate(mesh, triangle, barycentric);
  return material.emission * Rgb(texture_value(scene, material.emissive_texture, uv));
}

SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  const Material& material = material_of(scene, mesh);
  if (!material.is_emissive()) {
    return {};
  }
  const Vec3 front_normal = Triangle(mesh, hit.triangle).front_normal();
  const float front_cosine = -glm::dot(front_normal, direction);
  if (front_cosine <= 0.0F && !material.double_sided) {
    return {};
  }
  return {.radiance = emitted_radiance(scene, mesh, hit.triangle, hit.barycentric),
          .cosine = std::abs(front_cosine)};
}

}  // namespace foveola
