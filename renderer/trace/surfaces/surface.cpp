#include "renderer/trace/surfaces/surface.h"

#include <algorithm>
#include <cmath>

namespace foveola {
namespace {

/// Attenuation colours of zero would absorb infinitely.
constexpr float darkest_attenuation = 1e-6F;

void apply_textures(const Scene& scene, const Material& material, const MeshPoint& point,
                    Reflectance& reflectance) {
  const auto value = [&](const TextureUse& use) { return texture_value(scene, use, point); };
  reflectance.base_color *= Rgb(value(material.base_color_texture));
  const Vec4 metallic_roughness = value(material.metallic_roughness_texture);
  reflectance.roughness *= metallic_roughness.g;
  reflectance.metallic *= metallic_roughness.b;
  reflectance.specular *= value(material.specular_texture).a;
  reflectance.specular_color *= Rgb(value(material.specular_color_texture));
  reflectance.transmission *= value(material.transmission_texture).r;
  reflectance.clearcoat *= value(material.clearcoat_texture).r;
  reflectance.clearcoat_roughness *= value(material.clearcoat_roughness_texture).g;
  reflectance.sheen_color *= Rgb(value(material.sheen_color_texture));
  reflectance.sheen_roughness *= value(material.sheen_roughness_texture).a;
}

}  // namespace

Reflectance untextured_reflectance(const Material& material) {
  return {.base_color = material.base_color,
          .metallic = material.metallic,
          .roughness = material.roughness,
          .ior = material.ior,
          .specular = material.specular,
          .specular_color = material.specular_color,
          .transmission = material.transmission,
          .is_solid = material.is_solid,
          .clearcoat = material.clearcoat,
          .clearcoat_roughness = material.clearcoat_roughness,
          .sheen_color = material.sheen_color,
          .sheen_roughness = material.sheen_roughness};
}

Reflectance reflectance_at(const Scene& scene, const MeshPoint& point, bool is_back) {
  const Material& material = material_of(scene, point.mesh);
  Reflectance reflectance = untextured_reflectance(material);
  reflectance.from_inside = material.is_solid && is_back;
  if (!point.mesh.uv_sets.empty()) {
    apply_textures(scene, material, point, reflectance);
  }
  if (!point.mesh.colors.empty()) {
    reflectance.base_color *= Rgb(vertex_color(point));
  }
  return reflectance;
}

Mat3 world_normal_from_local(const Mat4& world_from_local) {
  const Mat3 linear(world_from_local);
  const float sign = std::copysign(1.0F, glm::determinant(linear));
  return {sign * glm::cross(linear[1], linear[2]), sign * glm::cross(linear[2], linear[0]),
          sign * glm::cross(linear[0], linear[1])};
}

Vec3 mapped_normal(const Scene& scene, const NormalMap& map, const MeshPoint& point,
                   const Instance* instance, const Vec3& normal) {
  if (!map.texture.exists() || point.mesh.tangents.empty()) {
    return normal;
  }
  const Vec4 tangent_and_sign =
      interpolate(point.mesh.tangents, point.mesh.triangles[point.triangle], point.barycentric);
  Vec3 tangent(tangent_and_sign);
  float sign = std::copysign(1.0F, tangent_and_sign.w);
  if (instance != nullptr) {
    const Mat3 linear(instance->world_from_local);
    tangent = linear * tangent;
    sign *= std::copysign(1.0F, glm::determinant(linear));
  }
  tangent -= glm::dot(tangent, normal) * normal;
  const float length = glm::length(tangent);
  if (!(length > 0.0F)) {
    return normal;
  }
  tangent /= length;
  const Vec3 texel = 2.0F * Vec3(texture_value(scene, map.texture, point)) - 1.0F;
  const Vec3 bitangent = sign * glm::cross(normal, tangent);
  return normalized_or(map.scale * (texel.x * tangent + texel.y * bitangent) + texel.z * normal,
                       normal);
}

float relative_width(float ray_width_m, float facing, float double_area) {
  constexpr float max_grazing = 0.05F;
  // The ray's width along the surface, between its narrow and its long axis.
  return ray_width_m / std::sqrt(double_area * std::max(std::abs(facing), max_grazing));
}

namespace {

/// Interpolated between the front's vertex normals in the world, of any length; zero if the mesh
/// has none.
Vec3 vertex_normal(const MeshPoint& point, const Instance* instance) {
  if (point.mesh.normals.empty()) {
    return Vec3(0.0F);
  }
  const Vec3 normal =
      interpolate(point.mesh.normals, point.mesh.triangles[point.triangle], point.barycentric);
  return instance == nullptr ? normal
                             : world_normal_from_local(instance->world_from_local) * normal;
}

NormalMap coat_normal_map(const Material& material) {
  return {material.clearcoat_normal_texture, material.clearcoat_normal_scale};
}

/// The transmittance of a clear coat for light from below against `direction`.
float coat_transmittance(const Scene& scene, const Material& material, const MeshPoint& point,
                         const Instance* instance, const Vec3& front_normal,
                         const Vec3& direction) {
  const bool is_inside = material.is_solid && glm::dot(front_normal, direction) > 0.0F;
  if (is_inside) {
    return 1.0F;
  }
  const Vec3 normal = mapped_normal(scene, coat_normal_map(material), point, instance,
                                    normalized_or(vertex_normal(point, instance), front_normal));
  const float strength =
      material.clearcoat * texture_value(scene, material.clearcoat_texture, point).r;
  return 1.0F - strength * clearcoat_reflectance(std::abs(glm::dot(normal, direction)));
}

}  // namespace

SurfacePoint surface_point(const Scene& scene, const Hit& hit, const Vec3& direction,
                           float ray_width_m) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  const Instance* instance = scene.instance_of(hit.object);
  const Triangle triangle(mesh, instance, hit.triangle);
  const Triangle::Front front = triangle.front();
  MeshPoint point{.mesh = mesh, .triangle = hit.triangle, .barycentric = hit.barycentric};
  SurfaceGeometryOf<float> geometry(triangle, triangle.normal_of(front),
                                    vertex_normal(point, instance), hit.barycentric, direction,
                                    hit.t);
  if (ray_width_m > 0.0F && !mesh.uv_sets.empty()) {
    point.relative_width = relative_width(ray_width_m, geometry.facing, front.double_area);
  }
  const auto mapped = [&](const NormalMap& map) {
    return map.texture.exists()
               ? geometry.mapped_shading_normal(
                     mapped_normal(scene, map, point, instance, geometry.smooth_normal), direction)
               : geometry.shading_normal;
  };
  const Material& material = material_of(scene, mesh);
  const Vec3 coat_normal = mapped(coat_normal_map(material));
  geometry.shading_normal = mapped(normal_map(material));
  return {geometry, reflectance_at(scene, point, geometry.facing < 0.0F), coat_normal};
}

Vec3 smooth_bulge(const Scene& scene, const Hit& hit, const Vec3& side) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  if (mesh.normals.empty()) {
    return Vec3(0.0F);
  }
  const Instance* instance = scene.instance_of(hit.object);
  const Triangle triangle(mesh, instance, hit.triangle);
  const Vec3 point = triangle.at(hit.barycentric);
  const auto& [a, b, c] = mesh.triangles[hit.triangle];
  Vec3 bulge(0.0F);
  const auto add = [&](std::uint32_t vertex, const Vec3& corner, float weight) {
    Vec3 normal = mesh.normals[vertex];
    if (instance != nullptr) {
      normal = world_normal_from_local(instance->world_from_local) * normal;
    }
    normal = normalized_or(normal, side);
    normal *= std::copysign(1.0F, glm::dot(normal, side));
    bulge -= weight * std::min(glm::dot(point - corner, normal), 0.0F) * normal;
  };
  add(a, triangle.p0, 1.0F - hit.barycentric.x - hit.barycentric.y);
  add(b, triangle.p1, hit.barycentric.x);
  add(c, triangle.p2, hit.barycentric.y);
  return bulge;
}

Rgb emitted_radiance(const Scene& scene, std::uint32_t object, std::uint32_t triangle,
                     const Vec2& barycentric, const Vec3& direction) {
  const MeshPoint point{scene.mesh_of(object), triangle, barycentric};
  const Material& material = material_of(scene, point.mesh);
  Rgb radiance = material.emission * Rgb(texture_value(scene, material.emissive_texture, point));
  if (material.clearcoat > 0.0F) {
    const Vec3 front_normal = Triangle(scene, object, triangle).front_normal();
    radiance *= coat_transmittance(scene, material, point, scene.instance_of(object), front_normal,
                                   direction);
  }
  return radiance;
}

SurfaceEmission surface_emission(const Scene& scene, const Hit& hit, const Vec3& direction) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  const Material& material = material_of(scene, mesh);
  if (!material.is_emissive()) {
    return {};
  }
  const Vec3 front_normal = Triangle(scene, hit.object, hit.triangle).front_normal();
  const float front_cosine = -glm::dot(front_normal, direction);
  if (front_cosine <= 0.0F && !material.double_sided) {
    return {};
  }
  return {.radiance = emitted_radiance(scene, hit.object, hit.triangle, hit.barycentric, direction),
          .cosine = std::abs(front_cosine)};
}

Rgb unlit_color(const Scene& scene, const Hit& hit) {
  const Mesh& mesh = scene.mesh_of(hit.object);
  const Material& material = material_of(scene, mesh);
  const MeshPoint point{mesh, hit.triangle, hit.barycentric};
  return material.base_color * Rgb(texture_value(scene, material.base_color_texture, point)) *
         Rgb(vertex_color(point));
}

Rgb absorption_per_m(const Material& material) {
  if (!material.is_solid || !std::isfinite(material.attenuation_distance_m)) {
    return Rgb(0.0F);
  }
  return -glm::log(glm::max(material.attenuation_color, Rgb(darkest_attenuation))) /
         material.attenuation_distance_m;
}

}  // namespace foveola
