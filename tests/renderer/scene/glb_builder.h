// Small glTF files for tests, made in memory: a JSON document, and the buffer that it describes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/vec.h"
#include "renderer/glb/glb_document.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/scene.h"
#include "tests/temporary_folder.h"

namespace foveola::test {

using Json = nlohmann::json;
using enum GlbComponent;

/// A document under construction and the bytes of its only buffer. Tests spoil `document` at will.
struct GlbBuilder : GlbDocument<Json> {
  GlbBuilder() { document = {{"asset", {{"version", "2.0"}}}}; }

  using GlbDocument::add_view;
  int add_view(const void* bytes, std::size_t size) {
    return add_view(std::span(static_cast<const std::byte*>(bytes), size));
  }

  template <typename T>
  int add_accessor(const std::vector<T>& values, GlbComponent component, const char* type,
                   std::size_t values_per_element) {
    return GlbDocument::add_accessor(std::as_bytes(std::span(values)), component, type,
                                     values.size() / values_per_element);
  }
  int add_vectors(const std::vector<Vec3>& values) {
    return add_accessor(values, float32, "VEC3", 1);
  }
  int add_uvs(const std::vector<Vec2>& values) { return add_accessor(values, float32, "VEC2", 1); }

  /// A mesh of one primitive.
  int add_mesh(Json primitive) {
    return add("meshes", {{"primitives", Json::array({std::move(primitive)})}});
  }

  /// The first primitive of the first mesh.
  Json& primitive() { return document["meshes"][0]["primitives"][0]; }

  /// A punctual light at a root with these properties.
  void add_light(const Json& light, Json node = Json::object()) {
    Json& lights = document["extensions"]["KHR_lights_punctual"]["lights"];
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size();
    lights.push_back(light);
    add_root(node);
  }

  /// An image of these encoded bytes, in the buffer, and a texture of it.
  int add_texture(const std::string& encoded) {
    const int view = add_view(encoded.data(), encoded.size());
    const int image = add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    return add("textures", {{"source", image}});
  }
};

/// The front-facing triangle (0,0,0), (1,0,0), (0,1,0) in a scene of its own.
inline GlbBuilder one_triangle() {
  GlbBuilder glb;
  const int positions = glb.add_vectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  glb.add_root({{"mesh", glb.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
  return glb;
}

/// one_triangle for a .gltf file: its buffer, which is not written, at one uri, and in its material
/// the image at the other.
GlbBuilder textured_triangle(const std::string& buffer_uri, const std::string& image_uri);

inline void expect_vec_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR(glm::distance(actual, expected), 0.0F, 1e-6F)
      << actual.x << ' ' << actual.y << ' ' << actual.z;
}

/// A test with a folder of its own.
class InTemporaryFolder : public ::testing::Test {
 protected:
  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    return folder_.write(name, content);
  }

 private:
  TemporaryFolder folder_;
};

/// A test of load_gltf.
class LoadGltf : public InTemporaryFolder {
 protected:
  Scene load(const GlbBuilder& glb) const { return load_bytes(glb.bytes()); }
  Scene load_bytes(const std::string& bytes, const std::string& name = "scene.glb") const;

  /// The text of the Error that loading throws; a failure of the test if it throws none.
  std::string error_of(const GlbBuilder& glb) const { return error_of_bytes(glb.bytes()); }
  std::string error_of_bytes(const std::string& bytes, const std::string& name = "scene.glb",
                             const SceneReading& reading = {}) const;
  /// The same of a strict loading, which the other one is not.
  std::string strict_error_of(const GlbBuilder& glb) const {
    return error_of_bytes(glb.bytes(), "scene.glb", {.strict = true});
  }
};

/// A PNG image of 8-bit or 16-bit samples, `channels` of them a pixel, row by row from the top.
std::string png(int width, int height, int channels, const std::vector<std::uint8_t>& samples);
std::string png(int width, int height, int channels, const std::vector<std::uint16_t>& samples);

/// A PNG image whose header announces 16384 x 16384 pixels of 8-bit red, green and blue, padded to
/// `size` bytes where it has less.
std::string huge_png(std::size_t size);

/// A small JPEG image of one colour.
std::string jpeg(int width, int height, std::uint8_t grey);

/// A PNG image.
std::string one_pixel(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// A triangle whose only material is `material`, with both sets of texture coordinates.
GlbBuilder with_material(const Json& material);

/// The parts of a material that have a base colour texture.
Json textured(int texture, int uv_set = 0);

}  // namespace foveola::test
