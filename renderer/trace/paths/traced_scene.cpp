#include "renderer/trace/paths/traced_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/opacity.h"
#include "renderer/trace/surfaces/surface.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {
namespace {

/// Whether a texture varies the layers of a surface on the fast path.
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
                      .refracts = material.refracts(),
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

/// The innermost solid around a place: the first that a ray leaves without entering.
std::optional<std::uint32_t> solid_around(const Scene& scene, const RayScene& rays,
                                          const Vec3& place, const Vec3& direction) {
  constexpr int max_crossings = 256;
  std::map<std::uint32_t, int> entered;
  Ray ray{.origin = place, .direction = direction};
  for (int crossing = 0; crossing < max_crossings; ++crossing) {
    const Hit hit = rays.closest_hit(ray);
    if (hit.missed()) {
      break;
    }
    const Material& material = material_of(scene, scene.mesh_of(hit.object));
    if (material.refracts()) {
      const Vec3 front = Triangle(scene, hit.object, hit.triangle).front_normal();
      if (glm::dot(front, direction) < 0.0F) {
        ++entered[hit.object];
      } else if (--entered[hit.object] < 0) {
        return hit.object;
      }
    }
    ray.t_min = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
  }
  return std::nullopt;
}

/// Whether its reflection or refraction is found only by sampling the surface.
bool is_smooth_glass_or_mirror(const Material& material) {
  return (material.refracts() && material.metallic < 1.0F &&
          !is_rough_glass(material.ior, material.roughness)) ||
         (material.metallic > 0.0F && material.roughness < min_roughness);
}

/// Lamps of less area, and spheres of less cross-section, are met by fewer than one in 300 rays
/// that a matte surface scatters a metre away.
constexpr float small_area_m2 = 0.01F;

bool is_small_lamp(const TracedObject& object, const Scene& scene, std::uint32_t index) {
  if (!object.shines || object.is_unlit) {
    return false;
  }
  float area = 0.0F;
  for (std::uint32_t i = 0; i < object.view.mesh->triangles.size() && area < small_area_m2; ++i) {
    area += 0.5F * Triangle(scene, index, i).front().double_area;
  }
  return area < small_area_m2;
}

bool is_met_by_chance(const PunctualLight& light, bool is_behind_rough_glass) {
  constexpr float small_sun_rad = 0.05F;
  if (light.kind == PunctualLight::Kind::directional) {
    return is_behind_rough_glass && light.angular_radius_rad < small_sun_rad;
  }
  return (light.radius_m > 0.0F || is_behind_rough_glass) &&
         std::numbers::pi_v<float> * light.radius_m * light.radius_m < small_area_m2;
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
  follows_suns_through_glass = false;
  for (std::uint32_t object = 0; object < source.object_count(); ++object) {
    objects.push_back(traced_object(source, object));
    const TracedObject& traced = objects.back();
    traits.push_back(traits_of(traced));
    has_absorption = has_absorption || max_component(traced.absorption_per_m) > 0.0F;
    has_other_lobes = has_other_lobes ||
                      (!traced.is_unlit && (!traced.is_on_fast_path || traced.layers.is_shiny));
    is_dark = is_dark && !traced.is_unlit;
    follows_suns_through_glass =
        follows_suns_through_glass || (traced.refracts && lights.has_sun_discs());
  }
}

Rgb TracedScene::absorption_at(const Vec3& place) const {
  if (!has_absorption) {
    return Rgb(0.0F);
  }
  // Two of three directions decide, since a solid's mesh may have holes.
  const auto around = [&](const Vec3& direction) {
    return solid_around(scene, rays, place, glm::normalize(direction));
  };
  const auto first = around({0.61F, 0.53F, -0.59F});
  const auto second = around({-0.71F, 0.37F, 0.47F});
  const auto found = first == second ? first : around({0.23F, -0.83F, 0.31F});
  const bool is_agreed = first == second || found == first || found == second;
  return found && is_agreed ? objects[*found].absorption_per_m : Rgb(0.0F);
}

std::optional<std::string> TracedScene::warning_of_lights_without_size() const {
  const std::size_t points = lights.sizeless_points();
  const std::size_t suns = lights.sizeless_suns();
  const bool hides_them = std::ranges::any_of(objects, [&](const TracedObject& object) {
    return is_smooth_glass_or_mirror(material_of(scene, *object.view.mesh));
  });
  if (points + suns == 0 || !hides_them) {
    return std::nullopt;
  }
  return fmt::format(
      "lights without a size ({}) are invisible behind smooth solid glass and in mirrors; give "
      "them one by {}",
      points + suns,
      suns == 0     ? "--light-radius METRES"
      : points == 0 ? "--sun-radius DEGREES"
                    : "--light-radius METRES and --sun-radius DEGREES");
}

std::optional<std::string> TracedScene::warning_of_lights_met_by_chance() const {
  if (std::ranges::none_of(objects, &TracedObject::refracts)) {
    return std::nullopt;
  }
  const bool is_rough = std::ranges::any_of(objects, [&](const TracedObject& object) {
    const Material& material = material_of(scene, *object.view.mesh);
    return object.refracts && is_rough_glass(material.ior, material.roughness);
  });
  std::ptrdiff_t lights_met = 0;
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    lights_met += is_small_lamp(objects[i], scene, i) ? 1 : 0;
  }
  lights_met += std::ranges::count_if(
      scene.lights, [&](const PunctualLight& light) { return is_met_by_chance(light, is_rough); });
  lights_met += is_rough && lights.has_bright_spots() ? 1 : 0;
  if (lights_met == 0) {
    return std::nullopt;
  }
  return fmt::format(
      "small lights ({}) behind {} glass are found by chance only, with noise; enlarge them "
      "(points by --light-radius METRES), or give the glass no volume",
      lights_met, is_rough ? "rough or solid" : "solid");
}

}  // namespace foveola
