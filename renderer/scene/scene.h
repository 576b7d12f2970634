// A scene: triangles, materials, textures and lights, immutable once loaded.
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

/// A material value's use of a texture.
struct TextureUse {
  int texture = -1;  ///< index into Scene::textures; -1: none
  int uv_set = 0;    ///< index into Mesh::uv_sets of every mesh with the material
  /// KHR_texture_transform: the texture's coordinates are this times (u, v, 1).
  Mat3x2 texture_from_mesh{1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};

  bool exists() const { return texture >= 0; }
};

enum class AlphaMode : std::uint8_t {
  opaque,  ///< alpha is ignored
  mask,    ///< surfaces whose alpha is below the cutoff are absent
  blend,   ///< a surface is present with the probability alpha
};

/// glTF's metallic-roughness material with the KHR_materials extensions; renderer/MATERIALS.md
/// describes each value. Factors multiply their textures. Defaults are glTF's, except for metallic.
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
  bool double_sided = false;  ///< emitters only: whether the back emits too
  bool unlit = false;         ///< emits its base colour, and reflects nothing

  float ior = 1.5F;             ///< index of refraction, >= 1
  float specular = 1.0F;        ///< strength of the dielectric's reflection, in [0, 1]
  Rgb specular_color{1.0F};     ///< its colour at normal incidence, >= 0
  float transmission = 0.0F;    ///< transmitted share of the light entering the dielectric
  bool is_solid = false;        ///< the mesh bounds a refracting volume; else it is a thin wall
  Rgb attenuation_color{1.0F};  ///< transmittance of a solid over the attenuation distance
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
  /// As normal_texture, with the same tangents; absent: the clear coat has no normal map.
  TextureUse clearcoat_normal_texture;
  TextureUse sheen_color_texture;
  TextureUse sheen_roughness_texture;  ///< alpha

  bool is_emissive() const { return max_component(emission) > 0.0F; }
  /// Whether light enters the volume that the mesh bounds.
  bool refracts() const { return is_solid && transmission > 0.0F; }
};

/// All texture uses of a material; most are unused. Material_: Material, const or not.
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
  std::vector<Vec3> normals;   ///< unit length, one per vertex, or empty: flat shading
  std::vector<Vec4> tangents;  ///< unit length and the bitangent's sign, one per vertex, or empty
  std::vector<Vec4> colors;    ///< linear, multiply base colour and alpha, one per vertex, or empty
  /// One list per set, one element per vertex. Holds all sets that the material's textures use, or
  /// none: then nothing is textured.
  std::vector<std::vector<Vec2>> uv_sets;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Size of the lists of `mesh`, in bytes.
std::size_t array_bytes(const Mesh& mesh);

/// An instance of a mesh that appears more than once.
struct Instance {
  std::string name;
  std::uint32_t prototype = 0;  ///< index into Scene::prototypes
  Mat4 world_from_local{1.0F};  ///< affine and invertible; it may mirror
};

/// Infinitely far light: constant, or an equirect image in the film's convention (centre -Z, u
/// increasing towards +X, first row +Y).
struct Environment {
  Rgb radiance{1.0F};  ///< multiplies the map, if there is one
  /// Rotation of the map about +Y: its azimuth a appears at azimuth a + rotation.
  double rotation_rad = 0.0;
  int map_width = 0;
  int map_height = 0;
  std::vector<Rgb> map;  ///< row-major, or empty: constant
};

/// A light of KHR_lights_punctual, without geometry of its own.
struct PunctualLight {
  enum class Kind : std::uint8_t { point, spot, directional };
  /// Function of a spot's intensity from its outer to its inner cone, where t rises from 0 to 1
  /// with the cosine of the angle to its direction.
  enum class ConeEdge : std::uint8_t {
    squared,              ///< t^2, as KHR_lights_punctual recommends
    smooth,               ///< 3 t^2 - 2 t^3, as in Cycles
    smooth_times_cosine,  ///< that times the cosine, within the inner cone too: Cycles before 4.0
  };

  std::string name;
  Kind kind = Kind::point;
  Vec3 position{0.0F};                ///< of points and spots
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< emission direction of all but points, unit length
  /// Points and spots: radiant intensity. Directional lights: normal irradiance.
  Rgb intensity{1.0F};
  float inner_cone_rad = 0.0F;          ///< half angle of a spot's full intensity
  float outer_cone_rad = 0.785398163F;  ///< half angle beyond which a spot emits nothing
  ConeEdge cone_edge = ConeEdge::squared;
  /// Points and spots: radius of a sphere that rays hit and pass through; 0: a point that no ray
  /// hits.
  float radius_m = 0.0F;
  /// Directional lights: radius of a disc in the sky that rays see; 0: a direction that no ray
  /// sees.
  float angular_radius_rad = 0.0F;
};

struct CameraView {
  std::string name;
  Vec3 position{0.0F};
  AzimuthElevation heading;
  /// Roll about the line of sight, clockwise as the camera sees it, in (-pi, pi]: its horizon then
  /// turns counter-clockwise in the picture. For ordinary pictures only; heads have none.
  double roll_rad = 0.0;
  /// Vertical field of view of an ordinary picture, in (0, pi); nullopt if the camera has none.
  std::optional<double> vertical_fov_rad;
  std::optional<double> aspect_ratio;  ///< width over height of that picture, if the file has it
};

struct Bounds {
  Vec3 lower{0.0F};
  Vec3 upper{0.0F};
};

/// Objects are numbered: first the meshes in world space, then the instances.
struct Scene {
  std::vector<Mesh> meshes;      ///< in world space
  std::vector<Mesh> prototypes;  ///< each in its own space, shown by instances only
  std::vector<Instance> instances;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::optional<Environment> environment;
  std::vector<PunctualLight> lights;
  std::vector<CameraView> cameras;
  std::vector<std::string> clips;     ///< unique names of the file's animations
  std::vector<std::string> warnings;  ///< one line each: requests of the file that were not met
  std::string sha256;                 ///< covers all files it was loaded from: see scene_hash.h
  /// All files that it was loaded from, and its textures' missing files.
  std::set<std::filesystem::path> files;
  /// The file-world position of this scene's (0, 0, 0), in metres. Not zero for scenes far from the
  /// file's origin, where floats would be too coarse.
  DVec3 origin{0.0};

  /// Converts a point of the file's world, in metres, to this scene.
  Vec3 from_file(const DVec3& position) const { return Vec3(position - origin); }

  std::size_t object_count() const { return meshes.size() + instances.size(); }
  /// The geometry of an object; an instance's is in its prototype's space.
  const Mesh& mesh_of(std::uint32_t object) const;
  /// Null for an object that is a mesh in world space.
  const Instance* instance_of(std::uint32_t object) const;
  const std::string& object_name(std::uint32_t object) const;
  /// The world position of a point of an object's geometry.
  Vec3 in_world(std::uint32_t object, const Vec3& position) const;

  /// Number of triangles of all objects, each instance counted.
  std::size_t triangle_count() const;
  /// World bounds of an object's vertices. Without vertices, lower is above upper.
  Bounds bounds_of(std::uint32_t object) const;
  /// World bounds of all objects' vertices; both zero for an empty scene.
  Bounds bounds() const;
};

/// World bounds of each instance's transformed prototype box. Without vertices, lower is above
/// upper.
std::vector<Bounds> boxes_of_instances(const Scene& scene);

}  // namespace foveola
