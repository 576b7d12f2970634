#include "renderer/trace/traced_scene.h"

#include <cstdint>

#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/opacity.h"
#include "renderer/trace/surface.h"

namespace foveola {
namespace {

/// Whether there is a texture that the layers of a surface on the fast path read.
bool has_reflectance_texture(const Material& material) {
  return material.base_color_texture.exists() || material.metallic_roughness_texture.exists() ||
         material.specular_texture.exists() || material.specular_color_texture.exists();
}

TracedObject traced_object(const Scene& scene, std::uint32_t object) {
  const Mesh& mesh = scene.mesh_of(object);
  const Material& material = material_of(scene, mesh);
  TracedObject traced{.view = {.mesh = &mesh, .instance = scene.instance_of(object)},
                      .is_unlit = material.unlit,
                      .is_thin_transmissive = is_thin_transmissive(material),
                      .shines = material.unlit || material.is_emissive(),
                      .absorption_per_m = absorption_per_m(material)};
  const Reflectance untextured = untextured_reflectance(material);
  traced.layers = fast_path_layers(untextured);
  traced.is_constant =
      mesh.colors.empty() && (mesh.uv_sets.empty() || !has_reflectance_texture(material));
  traced.is_on_fast_path =
      is_on_fast_path(untextured) && (!traced.is_constant || is_on_fast_path(traced.layers));
  traced.has_normal_map = material.normal_texture.exists() && !mesh.tangents.empty();
  return traced;
}

std::uint8_t traits_of(const TracedObject& object) {
  const auto trait = [](bool has_it, std::uint8_t bit) { return has_it ? bit : 0; };
  return static_cast<std::uint8_t>(
      trait(object.shines, ObjectTraits::shines) |
      trait(object.is_thin_transmissive, ObjectTraits::is_thin_transmissive) |
      trait(object.is_on_fast_path, ObjectTraits::is_on_fast_path) |
      trait(object.has_normal_map, ObjectTraits::has_normal_map));
}

}  // namespace

TracedScene::TracedScene(const Scene& source, const Workers& workers, const LightSampling& sampling,
                         KeptHierarchies* kept)
    : scene(source),
      rays(source, workers, kept),
      lights(source, sampling),
      tables(source.materials, workers) {
  has_absorption = false;
  has_other_lobes = false;
  is_dark = lights.empty();
  for (std::uint32_t object = 0; object < source.object_count(); ++object) {
    objects.push_back(traced_object(source, object));
    const TracedObject& traced = objects.back();
    traits.push_back(traits_of(traced));
    has_absorption = has_absorption || max_component(traced.absorption_per_m) > 0.0F;
    has_other_lobes = has_other_lobes ||
                      (!traced.is_unlit && (!traced.is_on_fast_path || traced.layers.is_shiny));
    is_dark = is_dark && !traced.is_unlit;
  }
}

}  // namespace foveola
