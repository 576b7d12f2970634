#include "tests/fuzz/load_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <string>

#include "renderer/base/error.h"
#include "renderer/scene/environment.h"
#include "renderer/scene/load_scene.h"
#include "tests/fuzz/input_bytes.h"

namespace foveola::test {
namespace fs = std::filesystem;
namespace {

/// A PNG of one pixel, (255, 0, 0, 128).
constexpr std::array<unsigned char, 70> image = {
    0x89, 'P',  'N',  'G',  0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 'I',  'H',
    'D',  'R',  0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00,
    0x00, 0x1F, 0x15, 0xC4, 0x89, 0x00, 0x00, 0x00, 0x0D, 'I',  'D',  'A',  'T',  0x78,
    0xDA, 0x63, 0xF8, 0xCF, 0xC0, 0xD0, 0x00, 0x00, 0x04, 0x81, 0x01, 0x80, 0xF3, 0x0B,
    0xDC, 0xA0, 0x00, 0x00, 0x00, 0x00, 'I',  'E',  'N',  'D',  0xAE, 0x42, 0x60, 0x82};

void write(const fs::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string_view image_bytes() {
  return {reinterpret_cast<const char*>(image.data()), image.size()};
}

/// The part of `input` up to the next record separator, which are both taken off it.
std::string_view next_part(std::string_view& input) {
  const std::size_t end = std::min(input.find('\x1E'), input.size());
  const std::string_view part = input.substr(0, end);
  input.remove_prefix(std::min(end + 1, input.size()));
  return part;
}

void check(const Scene& scene, const TextureUse& use, const Mesh& mesh) {
  if (!use.exists()) {
    return;
  }
  const auto texture = static_cast<std::size_t>(use.texture);
  check_that(texture < scene.textures.size(), "a texture is out of range");
  check_that(mesh.uv_sets.empty() || static_cast<std::size_t>(use.uv_set) < mesh.uv_sets.size(),
             "a UV set is out of range");
  const Vec2 uv = mesh.uv_sets.empty()
                      ? Vec2(0.0F)
                      : use.texture_from_mesh *
                            Vec3(mesh.uv_sets[static_cast<std::size_t>(use.uv_set)].front(), 1.0F);
  const Vec4 value = scene.textures[texture].sample(uv, 0.3F);
  check_that(value.r >= 0.0F && value.r <= 1.0F && value.a >= 0.0F && value.a <= 1.0F,
             "a texture's value is out of range");
}

void check(const Scene& scene, const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  check_that(static_cast<std::size_t>(mesh.material) < scene.materials.size(),
             "a material is out of range");
  check_that(mesh.normals.empty() || mesh.normals.size() == vertices, "normals are missing");
  check_that(mesh.tangents.empty() || mesh.tangents.size() == vertices, "tangents are missing");
  check_that(mesh.colors.empty() || mesh.colors.size() == vertices, "colours are missing");
  for (const std::vector<Vec2>& uvs : mesh.uv_sets) {
    check_that(uvs.size() == vertices, "texture coordinates are missing");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      check_that(vertex < vertices, "a vertex is out of range");
      check_that(is_finite(mesh.positions[vertex]), "a vertex is not finite");
    }
  }
  if (mesh.triangles.empty()) {
    return;
  }
  for (const TextureUse* use :
       texture_uses(scene.materials[static_cast<std::size_t>(mesh.material)])) {
    check(scene, *use, mesh);
  }
}

void check(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    check(scene, mesh);
  }
  for (const Mesh& mesh : scene.prototypes) {
    check(scene, mesh);
  }
  for (const Instance& instance : scene.instances) {
    check_that(instance.prototype < scene.prototypes.size(), "a prototype is out of range");
  }
}

void check(const Environment& environment) {
  const auto width = static_cast<std::size_t>(environment.map_width);
  check_that(environment.map.size() == width * static_cast<std::size_t>(environment.map_height),
             "pixels are missing");
  for (const Rgb& pixel : environment.map) {
    check_that(is_finite(pixel) && pixel.r >= 0.0F && pixel.g >= 0.0F && pixel.b >= 0.0F,
               "a pixel is no light");
  }
}

/// By their first bytes: EXR, HDR, PNG and JPEG.
bool is_image(std::string_view input) {
  constexpr std::array<std::string_view, 4> beginnings = {"\x76\x2F\x31\x01", "#?", "\x89PNG",
                                                          "\xFF\xD8\xFF"};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return input.starts_with(beginning); });
}

constexpr const char* environment_name = "environment";

}  // namespace

fs::path write_input(const fs::path& folder, std::string_view input) {
  if (input.starts_with("glTF") || input.starts_with("{")) {
    const fs::path file = folder / (input.starts_with("{") ? "scene.gltf" : "scene.glb");
    write(file, input);
    return file;
  }
  if (is_image(input)) {
    const fs::path file = folder / environment_name;
    write(file, input);
    return file;
  }
  const fs::path file = folder / "scene.obj";
  write(file, next_part(input));
  write(folder / "m.mtl", next_part(input));
  write(folder / "t.png", input.empty() ? image_bytes() : input);
  return file;
}

void write_surroundings(const fs::path& folder) {
  std::array<float, 16> numbers{};
  std::iota(numbers.begin(), numbers.end(), 0.0F);
  write(folder / "b.bin", {reinterpret_cast<const char*>(numbers.data()), sizeof numbers});
  write(folder / "t.png", image_bytes());
}

bool load_input(const fs::path& file) {
  try {
    if (file.filename() == environment_name) {
      Warnings warnings;
      check(load_environment(file, warnings));
    } else {
      check(load_scene_file(file, {.time_s = 0.5}));
    }
  } catch (const Error&) {
    return false;
  }
  return true;
}

}  // namespace foveola::test
