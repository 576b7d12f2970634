#include "renderer/trace/rays/opacity.h"

#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/rays/mesh_attributes.h"

namespace foveola {
namespace {

bool has_varying_alpha(const Material& material, const Mesh& mesh) {
  return (material.base_color_texture.exists() && !mesh.uv_sets.empty()) || !mesh.colors.empty();
}

float opacity_of_alpha(const Material& material, float alpha) {
  switch (material.alpha_mode) {
    case AlphaMode::opaque:
      return 1.0F;
    case AlphaMode::mask:
      return alpha < material.alpha_cutoff ? 0.0F : 1.0F;
    case AlphaMode::blend:
      break;
  }
  return alpha;
}

}  // namespace

float opacity(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
              const Vec2& barycentric) {
  const Material& material = material_of(scene, mesh);
  const MeshPoint point{mesh, triangle, barycentric};
  return opacity_of_alpha(material, material.alpha *
                                        texture_value(scene, material.base_color_texture, point).a *
                                        vertex_color(point).a);
}

bool has_opacity(const Scene& scene, const Mesh& mesh) {
  const Material& material = material_of(scene, mesh);
  if (material.alpha_mode == AlphaMode::opaque) {
    return false;
  }
  return has_varying_alpha(material, mesh) || opacity_of_alpha(material, material.alpha) < 1.0F;
}

bool is_invisible(const Scene& scene, const Mesh& mesh) {
  const Material& material = material_of(scene, mesh);
  return mesh.triangles.empty() ||
         (!has_varying_alpha(material, mesh) && opacity_of_alpha(material, material.alpha) <= 0.0F);
}

bool is_thin_transmissive(const Material& material) {
  return material.transmission > 0.0F && !material.is_solid && material.metallic < 1.0F &&
         material.roughness < min_roughness;
}

}  // namespace foveola
