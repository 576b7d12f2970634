#include "tests/renderer/scene/glb_builder.h"

#include <algorithm>
#include <memory>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "renderer/base/error.h"
#include "renderer/scene/load_scene.h"

namespace foveola::test {
namespace {

std::string encode(const std::string& format, OIIO::ImageSpec spec, const void* samples) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  output->set_ioproxy(&memory);
  spec["oiio:UnassociatedAlpha"] = 1;
  EXPECT_TRUE(output->open("image." + format, spec)) << output->geterror();
  EXPECT_TRUE(output->write_image(spec.format, samples)) << output->geterror();
  EXPECT_TRUE(output->close());
  return {bytes.begin(), bytes.end()};
}

}  // namespace

Scene LoadGltf::load_bytes(const std::string& bytes, const std::string& name) const {
  return load_gltf(write(name, bytes));
}

std::string LoadGltf::error_of_bytes(const std::string& bytes, const std::string& name) const {
  try {
    load_bytes(bytes, name);
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "loaded without an error";
  return {};
}

std::string png(int width, int height, int channels, const std::vector<std::uint8_t>& samples) {
  return encode("png", {width, height, channels, OIIO::TypeDesc::UINT8}, samples.data());
}

std::string png(int width, int height, int channels, const std::vector<std::uint16_t>& samples) {
  return encode("png", {width, height, channels, OIIO::TypeDesc::UINT16}, samples.data());
}

std::string huge_png(std::size_t size) {
  std::string image = png(1, 1, 3, std::vector<std::uint8_t>{1, 2, 3});
  image.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));
  image.replace(29, 4, "\x26\xAA\x87\xD3");  // the header's checksum
  image.resize(std::max(image.size(), size));
  return image;
}

std::string exr(int width, int height, const std::vector<float>& values) {
  return encode("openexr", {width, height, 3, OIIO::TypeDesc::FLOAT}, values.data());
}

std::string jpeg(int width, int height, std::uint8_t grey) {
  const std::vector<std::uint8_t> samples(static_cast<std::size_t>(3) * width * height, grey);
  return encode("jpeg", {width, height, 3, OIIO::TypeDesc::UINT8}, samples.data());
}

GlbBuilder with_material(const Json& material) {
  GlbBuilder glb = one_triangle();
  const int first = glb.add_uvs({{0, 0}, {1, 0}, {0, 1}});
  const int second = glb.add_uvs({{5, 5}, {6, 5}, {5, 6}});
  Json& primitive = glb.document["meshes"][0]["primitives"][0];
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
