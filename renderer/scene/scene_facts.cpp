#include "renderer/scene/scene_facts.h"

#include <algorithm>
#include <array>
#include <set>

namespace foveola {
namespace {

bool has_texture(const Material& material) {
  const auto uses = texture_uses(material);
  return std::ranges::any_of(uses, [](const TextureUse* use) { return use->exists(); });
}

struct MaterialFeature {
  const char* name;
  bool (*has)(const Material&);
};

constexpr std::array<MaterialFeature, 11> material_features = {{
    {"textures", has_texture},
    {"normal maps", [](const Material& m) { return m.normal_texture.exists(); }},
    {"metal", [](const Material& m) { return m.metallic > 0.0F; }},
    {"alpha cut-outs", [](const Material& m) { return m.alpha_mode == AlphaMode::mask; }},
    {"alpha blending", [](const Material& m) { return m.alpha_mode == AlphaMode::blend; }},
    {"thin transmission", [](const Material& m) { return m.transmission > 0.0F && !m.is_solid; }},
    {"solid glass", [](const Material& m) { return m.transmission > 0.0F && m.is_solid; }},
    {"clearcoat", [](const Material& m) { return m.clearcoat > 0.0F; }},
    {"sheen", [](const Material& m) { return max_component(m.sheen_color) > 0.0F; }},
    {"emission", [](const Material& m) { return m.is_emissive(); }},
    {"unlit", [](const Material& m) { return m.unlit; }},
}};

class FactFinder {
 public:
  explicit FactFinder(const Scene& scene) : scene_(scene), is_used_(scene.materials.size(), false) {
    for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
      add_object(scene.mesh_of(object));
    }
    facts_.objects = scene.object_count();
    facts_.instances = scene.instances.size();
    facts_.lights = scene.lights.size();
    facts_.materials = scene.materials.size();
    facts_.textures = scene.textures.size();
    facts_.bounds = scene.bounds();
    add_memory();
    add_features();
  }

  const SceneFacts& facts() const { return facts_; }

 private:
  void add_object(const Mesh& mesh) {
    const auto material = static_cast<std::size_t>(mesh.material);
    facts_.triangles += mesh.triangles.size();
    is_used_[material] = is_used_[material] || !mesh.triangles.empty();
    has_colors_ = has_colors_ || !mesh.colors.empty();
    if (scene_.materials[material].is_emissive()) {
      facts_.emissive_triangles += mesh.triangles.size();
    }
  }

  void add_memory() {
    for (const std::vector<Mesh>* meshes : {&scene_.meshes, &scene_.prototypes}) {
      for (const Mesh& mesh : *meshes) {
        facts_.stored_triangles += mesh.triangles.size();
        facts_.geometry_bytes += array_bytes(mesh);
      }
    }
    std::set<const Texels*> counted;
    for (const Texture& texture : scene_.textures) {
      facts_.texture_bytes += sizeof texture;
      if (counted.insert(&texture.texels()).second) {
        facts_.texture_bytes += texture.texels().memory_bytes();
      }
    }
    facts_.environment_bytes =
        scene_.environment ? scene_.environment->map.size() * sizeof(Rgb) : 0;
  }

  void add_features() {
    for (const MaterialFeature& feature : material_features) {
      add_feature(feature.name, is_in_a_used_material(feature));
    }
    add_feature("vertex colours", has_colors_);
    add_feature("instances", !scene_.instances.empty());
    add_feature("lights without geometry", !scene_.lights.empty());
    add_feature("environment", scene_.environment.has_value());
  }

  bool is_in_a_used_material(const MaterialFeature& feature) const {
    for (std::size_t i = 0; i < is_used_.size(); ++i) {
      if (is_used_[i] && feature.has(scene_.materials[i])) {
        return true;
      }
    }
    return false;
  }

  void add_feature(const char* name, bool is_there) {
    (is_there ? facts_.features : facts_.absent_features).emplace_back(name);
  }

  const Scene& scene_;
  SceneFacts facts_;
  std::vector<bool> is_used_;  ///< by material
  bool has_colors_ = false;
};

}  // namespace

SceneFacts facts_of(const Scene& scene) { return FactFinder(scene).facts(); }

bool has_light(const Scene& scene) {
  const auto shines = [](const PunctualLight& light) {
    return max_component(light.intensity) > 0.0F;
  };
  if (scene.environment && max_component(scene.environment->radiance) > 0.0F) {
    return true;
  }
  if (scene.object_count() > 0 && std::ranges::any_of(scene.lights, shines)) {
    return true;
  }
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    const Mesh& mesh = scene.mesh_of(object);
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!mesh.triangles.empty() && (material.is_emissive() || material.unlit)) {
      return true;
    }
  }
  return false;
}

}  // namespace foveola
