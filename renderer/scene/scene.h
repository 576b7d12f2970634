// What is rendered: triangles, materials, textures and an environment, immutable once loaded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/vec.h"
#include "renderer/scene/texture.h"

namespace foveola {

/// glTF's metallic-roughness material. Texture indices point into Scene::textures; -1 is none.
struct Material {
  std::string name;
  Rgb base_color{1.0F};  ///< linear reflectance in [0, 1]
  float alpha = 1.0F;    ///< multiplies the base colour texture's alpha
  float metallic = 0.0F;
  float roughness = 1.0F;  ///< perceptual; GGX alpha is its square
  Rgb emission{0.0F};      ///< radiance; multiplies the emissive texture
  int base_color_texture = -1;
  int metallic_roughness_texture = -1;  ///< green: roughness, blue: metallic
  int emissive_texture = -1;
  /// Surfaces whose alpha is below this let light pass; 0 where everything is opaque.
  float alpha_cutoff = 0.0F;
  bool double_sided = false;

  bool is_emissive() const { return max_component(emission) > 0.0F; }
  bool is_cut_out() const { return alpha_cutoff > 0.0F; }
};

/// Triangles of one material in world space. Front faces are counter-clockwise.
struct Mesh {
  std::string name;  ///< the object's name in the file
  int material = 0;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< unit length, one a vertex, or empty: flat shading
  std::vector<Vec2> uvs;      ///< one a vertex, or empty: nothing is textured
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Light from infinitely far: constant, or an equirect image in the convention of the film
/// (centre -Z, u increasing towards +X, first row +Y).
struct Environment {
  Rgb radiance{1.0F};  ///< multiplies the map where there is one
  int map_width = 0;
  int map_height = 0;
  std::vector<Rgb> map;  ///< row-major, or empty: constant
};

struct CameraView {
  std::string name;
  Vec3 position{0.0F};
  AzimuthElevation heading;
};

struct Bounds {
  Vec3 lower{0.0F};
  Vec3 upper{0.0F};
};

struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::optional<Environment> environment;
  std::vector<CameraView> cameras;
  std::vector<std::string> warnings;  ///< one line each: what the file asked for and did not get
  std::string sha256;                 ///< of the scene file

  std::size_t triangle_count() const;
  /// Of all vertices; both zero for an empty scene.
  Bounds bounds() const;
};

}  // namespace foveola
