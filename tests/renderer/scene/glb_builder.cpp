#include "tests/renderer/scene/glb_builder.h"

#include <algorithm>

#include "tests/encoded_image.h"
#include "tests/error_of.h"

namespace foveola::test {

GlbBuilder textured_triangle(const std::string& buffer_uri, const std::string& image_uri) {
  GlbBuilder glb = one_triangle();
  Json& primitive = glb.primitive();
  primitive["attributes"]["TEXCOORD_0"] = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}});
  glb.document["buffers"] = {{{"byteLength", glb.buffer.size()}, {"uri", buffer_uri}}};
  glb.add("images", {{"uri", image_uri}});
  const Json texture = {{"index", glb.add("textures", {{"source", 0}})}};
  primitive["material"] =
      glb.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", texture}}}});
  return glb;
}

Scene LoadGltf::load_bytes(const std::string& bytes, const std::string& name) const {
  return load_gltf(write(name, bytes));
}

std::string LoadGltf::error_of_bytes(const std::string& bytes, const std::string& name,
                                     const SceneReading& reading) const {
  const std::string error = test::error_of([&] { load_gltf(write(name, bytes), reading); });
  EXPECT_FALSE(error.empty()) << "loaded without an error";
  return error;
}

std::string png(int width, int height, int channels, const std::vector<std::uint8_t>& samples) {
  return encoded_image({"png", width, height, channels, samples});
}

std::string png(int width, int height, int channels, const std::vector<std::uint16_t>& samples) {
  return encoded_image({"png", width, height, channels, samples});
}

std::string huge_png(std::size_t size) {
  std::string image = png(1, 1, 3, std::vector<std::uint8_t>{1, 2, 3});
  image.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));
  image.replace(29, 4, "\x26\xAA\x87\xD3");  // the header's checksum
  image.resize(std::max(image.size(), size));
  return image;
}

std::string jpeg(int width, int height, std::uint8_t grey) {
  const std::vector<std::uint8_t> samples(static_cast<std::size_t>(3) * width * height, grey);
  return encoded_image({"jpeg", width, height, 3, samples});
}

GlbBuilder with_material(const Json& material) {
  GlbBuilder glb = one_triangle();
  const int first = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}});
  const int second = glb.add_uvs({{5, 5}, {6, 5}, {5, 6}});
  Json& primitive = glb.primitive();
  primitive["attributes"]["TEXCOORD_0"] = first;
  primitive["attributes"]["TEXCOORD_1"] = second;
  primitive["material"] = glb.add("materials", material);
  return glb;
}

Json textured(int texture, int uv_set) {
  return {
      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}, {"texCoord", uv_set}}}}}};
}

std::string one_pixel(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  return png(1, 1, 3, std::vector<std::uint8_t>{red, green, blue});
}

}  // namespace foveola::test
