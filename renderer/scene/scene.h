// What is rendered: triangles, materials, textures and lights, immutable once loaded.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/scene/textures/texture.h"

namespace foveola {

/// A texture as one of a material's values uses it.
struct TextureUse {
  int texture = -1;  ///< index into Scene::textures; -1: the value has no texture
  int uv_set = 0;    ///< index into Mesh::uv_sets of every mesh with the material
  /// KHR_texture_transform: the texture's coordinates are this times (u, v, 1).
  Mat3x2 texture_from_mesh{1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};

  bool exists() const { return texture >= 0; }
};

enum class AlphaMode : std::uint8_t {
  opaque,  ///< alpha is ignored
  mask,    ///< surfaces whose alpha is below the cutoff are not there
  blend,   ///< a surface is there with the probability alpha
};

/// glTF's metallic-roughness material with the KHR_materials extensions; renderer/MATERIALS.md says
/// what each value does. Factors multiply their textures. Defaults are glTF's, but for metallic.
struct Material {
  std::string name;

  Rgb base_color{1.0F};  ///< linear reflectance in [0, 1]
  float alpha = 1.0F;    ///< multiplies the base colour texture's alpha
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5F;  ///< for AlphaMode::mask
  float metallic = 0.0F;
  float roughness = 1.0F;     ///< perceptual; GGX alpha is its square
  float normal_scale = 1.0F;  ///< multiplies x and y of the normal texture
  Rgb emission{0.0F};         ///< radiance; multiplies the emissive texture
  bool double_sided = false;  ///< emitters only: whether the back shines too
  bool unlit = false;         ///< shines with its base colour, and reflects nothing

  float ior = 1.5F;             ///< index of refraction, >= 1
  float specular = 1.0F;        ///< strength of the dielectric's reflection, in [0, 1]
  Rgb specular_color{1.0F};     ///< its colour at normal incidence, >= 0
  float transmission = 0.0F;    ///< share of the light entering the dielectric that is let through
  bool is_solid = false;        ///< the mesh bounds a volume that refracts; else it is a thin wall
  Rgb attenuation_color{1.0F};  ///< what a solid leaves of light after the attenuation distance
  float attenuation_distance_m = std::numeric_limits<float>::infinity();
  float clearcoat = 0.0F;
  float clearcoat_roughness = 0.0F;
  float clearcoat_normal_scale = 1.0F;
  Rgb sheen_color{0.0F};
  float sheen_roughness = 0.0F;

  TextureUse base_color_texture;
  TextureUse metallic_roughness_texture;  ///< green: roughness, blue: metallic
  TextureUse normal_texture;              ///< tangent space, 2 * rgb - 1
  TextureUse emissive_texture;
  TextureUse specular_texture;  ///< alpha
  TextureUse specular_color_texture;
  TextureUse transmission_texture;         ///< red
  TextureUse clearcoat_texture;            ///< red
  TextureUse clearcoat_roughness_texture;  ///< green
  /// As normal_texture, with the same tangents; without it the clear coat has no normal map.
  TextureUse clearcoat_normal_texture;
  TextureUse sheen_color_texture;
  TextureUse sheen_roughness_texture;  ///< alpha

  bool is_emissive() const { return max_component(emission) > 0.0F; }
  /// Light enters the volume that the mesh bounds.
  bool refracts() const { return is_solid && transmission > 0.0F; }
};

/// All uses that a material can make of textures, of which few exist. Material_: Material, const or
/// not.
template <typename Material_>
auto texture_uses(Material_& m) {
  return std::array{
      &m.base_color_texture,       &m.metallic_roughness_texture, &m.normal_texture,
      &m.emissive_texture,         &m.specular_texture,           &m.specular_color_texture,
      &m.transmission_texture,     &m.clearcoat_texture,          &m.clearcoat_roughness_texture,
      &m.clearcoat_normal_texture, &m.sheen_color_texture,        &m.sheen_roughness_texture};
}

/// Triangles of one material. Front faces are counter-clockwise.
struct Mesh {
  std::string name;  ///< the object's name in the file
  int material = 0;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;   ///< unit length, one a vertex, or empty: flat shading
  std::vector<Vec4> tangents;  ///< unit length and the bitangent's sign, one a vertex, or empty
  std::vector<Vec4> colors;    ///< linear, multiply base colour and alpha, one a vertex, or empty
  /// One list a set, one element a vertex. Has all sets that the material's textures use, or none:
  /// then nothing is textured.
  std::vector<std::vector<Vec2>> uv_sets;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What the lists of `mesh` hold, in bytes.
std::size_t array_bytes(const Mesh& mesh);

/// A further appearance of a mesh that stands in more than one place.
struct Instance {
  std::string name;
  std::uint32_t prototype = 0;  ///< index into Scene::prototypes
  Mat4 world_from_local{1.0F};  ///< affine and invertible; it may mirror
};

/// Light from infinitely far: constant, or an equirect image in the convention of the film
/// (centre -Z, u increasing towards +X, first row +Y).
struct Environment {
  Rgb radiance{1.0F};  ///< multiplies the map where there is one
  /// Turns the map about +Y: what it shows at azimuth a stands at azimuth a + rotation.
  double rotation_rad = 0.0;
  int map_width = 0;
  int map_height = 0;
  std::vector<Rgb> map;  ///< row-major, or empty: constant
};

/// KHR_lights_punctual's lights, which have no geometry of their own.
struct PunctualLight {
  enum class Kind : std::uint8_t { point, spot, directional };
  /// How a spot's intensity rises from its outer to its inner cone, where t rises from 0 to 1 as
  /// the cosine of the angle to its direction does.
  enum class ConeEdge : std::uint8_t {
    squared,              ///< t^2, as KHR_lights_punctual recommends
    smooth,               ///< 3 t^2 - 2 t^3, as in Cycles
    smooth_times_cosine,  ///< that times the cosine, within the inner cone too: Cycles before 4.0
  };

  std::string name;
  Kind kind = Kind::point;
  Vec3 position{0.0F};                ///< where points and spots stand
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< where spots and directional lights shine, unit length
  /// Points and spots: radiant intensity. Directional lights: irradiance across their direction.
  Rgb intensity{1.0F};
  float inner_cone_rad = 0.0F;          ///< half angle of a spot's full intensity
  float outer_cone_rad = 0.785398163F;  ///< half angle beyond which a spot gives nothing
  ConeEdge cone_edge = ConeEdge::squared;
  /// Points and spots are spheres of this size, which rays meet and pass through; 0: they have no
  /// size and no ray meets them.
  float radius_m = 0.0F;
  /// Directional lights are discs of this size in the sky, which rays see; 0: they have no size and
  /// no ray sees them.
  float angular_radius_rad = 0.0F;
};

struct CameraView {
  std::string name;
  Vec3 position{0.0F};
  AzimuthElevation heading;
  /// Turn about the line of sight, clockwise as the camera sees it, in (-pi, pi]: its horizon then
  /// turns counter-clockwise in the picture. Only an ordinary picture has it, no head.
  double roll_rad = 0.0;
  /// Height of what an ordinary picture shows, in (0, pi); none if the camera does not say.
  std::optional<double> vertical_fov_rad;
  std::optional<double> aspect_ratio;  ///< width over height of that picture, if the file says it
};

struct Bounds {
  Vec3 lower{0.0F};
  Vec3 upper{0.0F};
};

/// Objects are numbered: first the meshes, which stand in the world as they are, then the
/// instances.
struct Scene {
  std::vector<Mesh> meshes;      ///< in world space
  std::vector<Mesh> prototypes;  ///< each in a space of its own, shown by instances only
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::optional<Environment> environment;
  std::vector<PunctualLight> lights;
  std::vector<CameraView> cameras;
  std::vector<std::string> clips;     ///< names of the file's animations, no two of them equal
  std::vector<std::string> warnings;  ///< one line each: what the file asked for and did not get
  std::string sha256;                 ///< covers all files it was loaded from: see scene_hash.h
  /// All that it was loaded from, and those of its textures that are not there.
  std::set<std::filesystem::path> files;
  /// Where this scene's (0, 0, 0) lies in the file's world, in metres. Not zero for scenes far from
  /// the file's own origin, where floats would be too coarse.
  DVec3 origin{0.0};

  /// Where a point of the file's world, in metres, lies in this scene.
  Vec3 from_file(const DVec3& position) const { return Vec3(position - origin); }

  std::size_t object_count() const { return meshes.size() + instances.size(); }
  /// The geometry of an object; an instance's is in its prototype's space.
  const Mesh& mesh_of(std::uint32_t object) const;
  /// Null for an object that is a mesh in world space.
  const Instance* instance_of(std::uint32_t object) const;
  const std::string& object_name(std::uint32_t object) const;
  /// Where a position of an object's geometry lies in the world.
  Vec3 in_world(std::uint32_t object, const Vec3& position) const;

  /// The triangles of all objects, each instance counted.
  std::size_t triangle_count() const;
  /// The bounds of an object's vertices in the world. Without vertices, the lower ones are above
  /// the upper ones.
  Bounds bounds_of(std::uint32_t object) const;
  /// The bounds of all objects' vertices; both zero for an empty scene.
  Bounds bounds() const;
};

/// A box around each instance, that of its prototype's box. Without vertices, the lower bounds are
/// above the upper ones.
std::vector<Bounds> boxes_of_instances(const Scene& scene);

}  // namespace foveola
