#include "renderer/trace/cut_out.h"

#include "renderer/trace/triangle.h"

namespace foveola {
namespace {

const Material& material_of(const Scene& scene, const Mesh& mesh) {
  return scene.materials[static_cast<std::size_t>(mesh.material)];
}

}  // namespace

bool has_varying_alpha(const Scene& scene, const Mesh& mesh) {
  const Material& material = material_of(scene, mesh);
  return material.alpha_mode != AlphaMode::opaque && material.base_color_texture.exists() &&
         !mesh.uv_sets.empty();
}

bool is_hole(const Scene& scene, const Mesh& mesh, std::uint32_t triangle,
             const Vec2& barycentric) {
  const Material& material = material_of(scene, mesh);
  if (material.alpha_mode == AlphaMode::opaque) {
    return false;
  }
  if (!has_varying_alpha(scene, mesh)) {
    return material.alpha < material.alpha_cutoff;
  }
  const Texture& texture =
      scene.textures[static_cast<std::size_t>(material.base_color_texture.texture)];
  const Vec2 uv = interpolate(mesh.uv_sets[0], mesh.triangles[triangle], barycentric);
  return material.alpha * texture.sample(uv).a < material.alpha_cutoff;
}

bool is_invisible(const Scene& scene, const Mesh& mesh) {
  return mesh.triangles.empty() ||
         (!has_varying_alpha(scene, mesh) && is_hole(scene, mesh, 0, Vec2(0.0F)));
}

}  // namespace foveola
