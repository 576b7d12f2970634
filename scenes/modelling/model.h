// A scene in memory on its way to a .glb file: what the built-in generators produce.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "scenes/default_seed.h"
#include "scenes/modelling/seed.h"
#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

static_assert(mix(default_seed) == 0, "the built-in scenes are not varied");

/// Eight bits a channel: red, green, blue (sRGB-encoded) and alpha; row-major from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height bytes
};

/// glTF's metallic-roughness material.
struct Material {
  std::string name;
  Rgb base_color{0.8F};  ///< linear, in [0, 1]; multiplies the image
  float metallic = 0.0F;
  float roughness = 1.0F;
  Rgb emission{0.0F};         ///< radiance; one-sided unless double_sided
  int base_color_image = -1;  ///< index into Model::images; -1: none
  float alpha_cutoff = 0.0F;  ///< light passes where the image's alpha is below it; 0: opaque
  float transmission = 0.0F;  ///< share of light, in [0, 1], that passes as through thin glass
  float clearcoat = 0.0F;     ///< strength, in [0, 1], of a smooth varnish over everything else
  bool double_sided = false;
};

/// Triangles of one material. Front faces are counter-clockwise, and normals lie on their side.
struct Surface {
  int material = 0;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  ///< unit length, one a position
  std::vector<Vec2> uvs;      ///< one a position, or empty where the material has no image
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Something that has a name, in surfaces of one or more materials.
struct Object {
  std::string name;
  std::vector<Surface> surfaces;
};

struct Camera {
  std::string name;
  Vec3 position{0.0F};
  AzimuthElevation heading;
};

struct Model {
  std::uint32_t seed = default_seed;  ///< everything random in the scene derives from it
  std::vector<Image> images;
  std::vector<Material> materials;
  std::vector<Object> objects;
  std::vector<Camera> cameras;

  std::size_t triangle_count() const;
  /// The seed of the random thing that has this number in the scene. By default it is the number
  /// itself.
  Seed stream(std::uint32_t number) const { return Seed(number ^ mix(seed)); }
};

/// A shape that is to be made of a material of the model.
struct Part {
  int material = 0;
  Shape shape;
  double crease_deg = 40.0;  ///< edges that bend more than this stay sharp
};

/// These return the index under which the model now holds the image or material.
int add_image(Model& model, Image image);
int add_material(Model& model, Material material);

/// A dielectric material whose colour is the image.
int add_textured_material(Model& model, const char* name, Image image, float roughness);

/// Rounds the shapes to single precision, gives them normals and adds them as one object. Triangles
/// without area are dropped, and parts without triangles.
void add_object(Model& model, std::string name, const std::vector<Part>& parts);

}  // namespace foveola::scenes
