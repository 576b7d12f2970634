#include "scenes/modelling/glb_writer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "scenes/modelling/png.h"

namespace foveola::scenes {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

constexpr int float_type = 5126;
constexpr int uint16_type = 5123;
constexpr int uint32_type = 5125;
constexpr int vertex_target = 34962;
constexpr int index_target = 34963;
constexpr double default_yfov_rad = 1.0;
constexpr double clearcoat_roughness = 0.03;  ///< polished, yet found by light sampling

Json array_from(const Vec3& v) { return {v.x, v.y, v.z}; }

void pad(std::string& chunk, char filler) { chunk.resize((chunk.size() + 3) / 4 * 4, filler); }

/// The document and the binary chunk that its buffer views point into.
class GlbWriter {
 public:
  explicit GlbWriter(const Model& model) : model_(model) {}

  std::string write() {
    document_["asset"] = {{"version", "2.0"}, {"generator", "Foveola"}};
    document_["scene"] = 0;
    document_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    write_objects();
    write_cameras();
    write_materials();
    write_images();
    pad(binary_, '\0');
    document_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return assembled();
  }

 private:
  /// Adds `bytes` and returns the index of their buffer view.
  std::size_t add_view(std::span<const std::byte> bytes, int target) {
    pad(binary_, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
    if (target != 0) {
      view["target"] = target;
    }
    binary_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return add("bufferViews", std::move(view));
  }

  template <typename T>
  std::size_t add_accessor(const std::vector<T>& items, int component, std::size_t count,
                           const char* type, int target) {
    const std::size_t view = add_view(std::as_bytes(std::span(items)), target);
    return add(
        "accessors",
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  }

  std::size_t add_positions(const std::vector<Vec3>& positions) {
    Vec3 lower = positions.front();
    Vec3 upper = positions.front();
    for (const Vec3& position : positions) {
      lower = glm::min(lower, position);
      upper = glm::max(upper, position);
    }
    const std::size_t accessor =
        add_accessor(positions, float_type, positions.size(), "VEC3", vertex_target);
    document_["accessors"][accessor]["min"] = array_from(lower);
    document_["accessors"][accessor]["max"] = array_from(upper);
    return accessor;
  }

  /// In the shorter type where it holds them; its greatest value means something else to renderers.
  std::size_t add_indices(const Surface& surface) {
    const std::size_t count = 3 * surface.triangles.size();
    if (surface.positions.size() > std::numeric_limits<std::uint16_t>::max()) {
      return add_accessor(surface.triangles, uint32_type, count, "SCALAR", index_target);
    }
    std::vector<std::uint16_t> indices;
    indices.reserve(count);
    for (const auto& triangle : surface.triangles) {
      for (const std::uint32_t corner : triangle) {
        indices.push_back(static_cast<std::uint16_t>(corner));
      }
    }
    return add_accessor(indices, uint16_type, count, "SCALAR", index_target);
  }

  Json primitive(const Surface& surface) {
    Json attributes = {{"POSITION", add_positions(surface.positions)}};
    attributes["NORMAL"] =
        add_accessor(surface.normals, float_type, surface.normals.size(), "VEC3", vertex_target);
    if (!surface.uvs.empty()) {
      attributes["TEXCOORD_0"] =
          add_accessor(surface.uvs, float_type, surface.uvs.size(), "VEC2", vertex_target);
    }
    return {{"attributes", std::move(attributes)},
            {"indices", add_indices(surface)},
            {"material", surface.material}};
  }

  void write_objects() {
    for (const Object& object : model_.objects) {
      Json primitives = Json::array();
      for (const Surface& surface : object.surfaces) {
        if (!surface.triangles.empty()) {
          primitives.push_back(primitive(surface));
        }
      }
      if (!primitives.empty()) {
        const std::size_t mesh =
            add("meshes", {{"name", object.name}, {"primitives", std::move(primitives)}});
        add_node({{"name", object.name}, {"mesh", mesh}});
      }
    }
  }

  void write_cameras() {
    for (const Camera& camera : model_.cameras) {
      const std::size_t index =
          add("cameras", {{"name", camera.name},
                          {"type", "perspective"},
                          {"perspective", {{"yfov", default_yfov_rad}, {"znear", 0.01}}}});
      const Quat azimuth =
          glm::angleAxis(static_cast<float>(-camera.heading.azimuth_rad), Vec3(0.0F, 1.0F, 0.0F));
      const Quat elevation =
          glm::angleAxis(static_cast<float>(camera.heading.elevation_rad), Vec3(1.0F, 0.0F, 0.0F));
      const Quat rotation = azimuth * elevation;
      add_node({{"name", camera.name},
                {"camera", index},
                {"translation", array_from(camera.position)},
                {"rotation", {rotation.x, rotation.y, rotation.z, rotation.w}}});
    }
  }

  void write_materials() {
    for (const Material& material : model_.materials) {
      add("materials", json_from(material));
    }
  }

  Json json_from(const Material& material) {
    const Rgb& color = material.base_color;
    Json surface = {{"baseColorFactor", {color.r, color.g, color.b, 1.0}},
                    {"metallicFactor", material.metallic},
                    {"roughnessFactor", material.roughness}};
    if (material.base_color_image >= 0) {
      surface["baseColorTexture"] = {{"index", material.base_color_image}};
    }
    Json result = {{"name", material.name}, {"pbrMetallicRoughness", std::move(surface)}};
    write_emission(material.emission, result);
    if (material.transmission > 0.0F) {
      add_extension("KHR_materials_transmission", {{"transmissionFactor", material.transmission}},
                    result);
    }
    if (material.clearcoat > 0.0F) {
      add_extension("KHR_materials_clearcoat",
                    {{"clearcoatFactor", material.clearcoat},
                     {"clearcoatRoughnessFactor", clearcoat_roughness}},
                    result);
    }
    if (material.alpha_cutoff > 0.0F) {
      result["alphaMode"] = "MASK";
      result["alphaCutoff"] = material.alpha_cutoff;
    }
    if (material.double_sided) {
      result["doubleSided"] = true;
    }
    return result;
  }

  void write_emission(const Rgb& emission, Json& material) {
    const float strength = max_component(emission);
    if (strength <= 0.0F) {
      return;
    }
    const float divisor = glm::max(strength, 1.0F);
    material["emissiveFactor"] = array_from(emission / divisor);
    if (strength > 1.0F) {
      add_extension("KHR_materials_emissive_strength", {{"emissiveStrength", strength}}, material);
    }
  }

  /// Gives the material an extension, which the document then lists among those it uses.
  void add_extension(const char* name, Json values, Json& material) {
    material["extensions"][name] = std::move(values);
    Json& used = document_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end()) {
      used.push_back(name);
    }
  }

  void write_images() {
    for (const Image& image : model_.images) {
      const std::vector<std::byte> file = png_from(image);
      const std::size_t view = add_view(file, 0);
      const std::size_t source = add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
      add("textures", {{"source", source}});
    }
  }

  void add_node(Json node) {
    document_["scenes"][0]["nodes"].push_back(add("nodes", std::move(node)));
  }

  std::size_t add(const char* list, Json item) {
    document_[list].push_back(std::move(item));
    return document_[list].size() - 1;
  }

  std::string assembled() {
    std::string json = document_.dump();
    pad(json, ' ');
    std::string file;
    const auto append_uint32 = [&](std::size_t value) {
      const auto word = static_cast<std::uint32_t>(value);
      file.append(reinterpret_cast<const char*>(&word), sizeof(word));
    };
    constexpr std::size_t header_size = 12;
    constexpr std::size_t chunk_header_size = 8;
    file += "glTF";
    append_uint32(2);
    append_uint32(header_size + 2 * chunk_header_size + json.size() + binary_.size());
    append_uint32(json.size());
    file += "JSON" + json;
    append_uint32(binary_.size());
    file += std::string("BIN\0", 4) + binary_;
    return file;
  }

  const Model& model_;
  Json document_;
  std::string binary_;
};

}  // namespace

std::string glb_from(const Model& model) { return GlbWriter(model).write(); }

}  // namespace foveola::scenes
