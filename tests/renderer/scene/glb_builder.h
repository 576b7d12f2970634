// Small glTF files for tests, made in memory: a JSON document, and the buffer that it describes.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "tests/temporary_folder.h"

namespace foveola::test {

using Json = nlohmann::json;

enum ComponentType : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// A document under construction and the bytes of its only buffer. Tests spoil `document` at will.
struct GlbBuilder {
  Json document = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  /// Appends `bytes`, 4-byte aligned, and returns the index of a buffer view of exactly them.
  int add_view(const void* bytes, std::size_t size) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}});
    buffer.append(static_cast<const char*>(bytes), size);
    return last("bufferViews");
  }

  template <typename T>
  int add_accessor(const std::vector<T>& values, ComponentType component, const char* type,
                   std::size_t values_per_element) {
    const int view = add_view(values.data(), values.size() * sizeof(T));
    document["accessors"].push_back({{"bufferView", view},
                                     {"componentType", static_cast<int>(component)},
                                     {"count", values.size() / values_per_element},
                                     {"type", type}});
    return last("accessors");
  }
  int add_vectors(const std::vector<Vec3>& values) { return add_accessor(values, f32, "VEC3", 1); }
  int add_uvs(const std::vector<Vec2>& values) { return add_accessor(values, f32, "VEC2", 1); }

  /// Appends `item` to the array `name` of the document and returns its index.
  int add(const char* name, Json item) {
    document[name].push_back(std::move(item));
    return last(name);
  }

  /// A mesh of one primitive.
  int add_mesh(Json primitive) {
    return add("meshes", {{"primitives", Json::array({std::move(primitive)})}});
  }

  /// A node, which is also listed in scene 0.
  int add_root(Json node) {
    const int index = add("nodes", std::move(node));
    document["scenes"][0]["nodes"].push_back(index);
    return index;
  }

  /// An image of these encoded bytes, in the buffer, and a texture of it.
  int add_texture(const std::string& encoded) {
    const int view = add_view(encoded.data(), encoded.size());
    const int image = add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    return add("textures", {{"source", image}});
  }

  std::string bytes() const {
    Json complete = document;
    if (!buffer.empty() && !complete.contains("buffers")) {
      complete["buffers"].push_back({{"byteLength", buffer.size()}});
    }
    return container(complete.dump(), buffer);
  }

  /// The GLB container around any JSON text and buffer.
  static std::string container(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t length = 20 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
    std::string bytes = "glTF" + word(2) + word(length) + word(json.size()) + "JSON" + json;
    if (!binary.empty()) {
      bytes += word(binary.size()) + std::string("BIN\0", 4) + binary;
    }
    return bytes;
  }

 private:
  static std::string word(std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &bits, 4);
    return bytes;
  }
  int last(const char* name) const { return static_cast<int>(document[name].size()) - 1; }
};

/// The front-facing triangle (0,0,0), (1,0,0), (0,1,0) in a scene of its own.
inline GlbBuilder one_triangle() {
  GlbBuilder glb;
  const int positions = glb.add_vectors({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  glb.add_root({{"mesh", glb.add_mesh({{"attributes", {{"POSITION", positions}}}})}});
  return glb;
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
  std::string error_of_bytes(const std::string& bytes, const std::string& name = "scene.glb") const;
};

/// A PNG image of 8-bit or 16-bit samples, `channels` of them a pixel, row by row from the top.
std::string png(int width, int height, int channels, const std::vector<std::uint8_t>& samples);
std::string png(int width, int height, int channels, const std::vector<std::uint16_t>& samples);

/// A PNG image whose header announces 16384 x 16384 pixels of 8-bit red, green and blue, padded to
/// `size` bytes where it has less.
std::string huge_png(std::size_t size);

/// An EXR image of floats: red, green and blue of each pixel.
std::string exr(int width, int height, const std::vector<float>& values);

/// A small JPEG image of one colour.
std::string jpeg(int width, int height, std::uint8_t grey);

/// A PNG image.
std::string one_pixel(std::uint8_t red, std::uint8_t green, std::uint8_t blue);

/// A triangle whose only material is `material`, with both sets of texture coordinates.
GlbBuilder with_material(const Json& material);

/// The parts of a material that have a base colour texture.
Json textured(int texture, int uv_set = 0);

}  // namespace foveola::test
