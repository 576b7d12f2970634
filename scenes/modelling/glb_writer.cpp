#include "scenes/modelling/glb_writer.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "renderer/glb/glb_document.h"
#include "scenes/modelling/png.h"

namespace foveola::scenes {
namespace {

using Json = nlohmann::ordered_json;

constexpr double default_yfov_rad = 1.0;
constexpr double clearcoat_roughness = 0.03;  ///< polished, yet found by light sampling

Json array_from(const Vec3& v) { return {v.x, v.y, v.z}; }

class ModelWriter {
 public:
  explicit ModelWriter(const Model& model) : model_(model) {}

  std::string write() {
    glb_.document["asset"] = {{"version", "2.0"}, {"generator", "Foveola"}};
    glb_.document["scene"] = 0;
    glb_.document["scenes"] = Json::array({{{"nodes", Json::array()}}});
    write_objects();
    write_cameras();
    write_materials();
    write_images();
    return glb_.bytes();
  }

 private:
  template <typename T>
  int add_accessor(const std::vector<T>& items, GlbComponent component, std::size_t count,
                   const char* type, GlbTarget target) {
    return glb_.add_accessor(std::as_bytes(std::span(items)), component, type, count, target);
  }
  template <typename Vector>
  int add_vectors(const std::vector<Vector>& vectors, const char* type) {
    return add_accessor(vectors, GlbComponent::float32, vectors.size(), type, GlbTarget::vertices);
  }

  int add_positions(const std::vector<Vec3>& positions) {
    Vec3 lower = positions.front();
    Vec3 upper = positions.front();
    for (const Vec3& position : positions) {
      lower = glm::min(lower, position);
      upper = glm::max(upper, position);
    }
    const int accessor = add_vectors(positions, "VEC3");
    glb_.document["accessors"][accessor]["min"] = array_from(lower);
    glb_.document["accessors"][accessor]["max"] = array_from(upper);
    return accessor;
  }

  /// In the shorter type where it holds them; its greatest value means something else to renderers.
  int add_indices(const Surface& surface) {
    const std::size_t count = 3 * surface.triangles.size();
    if (surface.positions.size() > std::numeric_limits<std::uint16_t>::max()) {
      return add_accessor(surface.triangles, GlbComponent::uint32, count, "SCALAR",
                          GlbTarget::indices);
    }
    std::vector<std::uint16_t> indices;
    indices.reserve(count);
    for (const auto& triangle : surface.triangles) {
      for (const std::uint32_t corner : triangle) {
        indices.push_back(static_cast<std::uint16_t>(corner));
      }
    }
    return add_accessor(indices, GlbComponent::uint16, count, "SCALAR", GlbTarget::indices);
  }

  Json primitive(const Surface& surface) {
    Json attributes = {{"POSITION", add_positions(surface.positions)}};
    attributes["NORMAL"] = add_vectors(surface.normals, "VEC3");
    if (!surface.uvs.empty()) {
      attributes["TEXCOORD_0"] = add_vectors(surface.uvs, "VEC2");
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
        const int mesh =
            glb_.add("meshes", {{"name", object.name}, {"primitives", std::move(primitives)}});
        glb_.add_root({{"name", object.name}, {"mesh", mesh}});
      }
    }
  }

  void write_cameras() {
    for (const Camera& camera : model_.cameras) {
      const int index =
          glb_.add("cameras", {{"name", camera.name},
                               {"type", "perspective"},
                               {"perspective", {{"yfov", default_yfov_rad}, {"znear", 0.01}}}});
      const Quat azimuth =
          glm::angleAxis(static_cast<float>(-camera.heading.azimuth_rad), Vec3(0.0F, 1.0F, 0.0F));
      const Quat elevation =
          glm::angleAxis(static_cast<float>(camera.heading.elevation_rad), Vec3(1.0F, 0.0F, 0.0F));
      const Quat rotation = azimuth * elevation;
      glb_.add_root({{"name", camera.name},
                     {"camera", index},
                     {"translation", array_from(camera.position)},
                     {"rotation", {rotation.x, rotation.y, rotation.z, rotation.w}}});
    }
  }

  void write_materials() {
    for (const Material& material : model_.materials) {
      glb_.add("materials", json_from(material));
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
    Json& used = glb_.document["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end()) {
      used.push_back(name);
    }
  }

  void write_images() {
    for (const Image& image : model_.images) {
      const std::vector<std::byte> file = png_from(image);
      const int view = glb_.add_view(file);
      const int source = glb_.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
      glb_.add("textures", {{"source", source}});
    }
  }

  const Model& model_;
  GlbDocument<Json> glb_;
};

}  // namespace

std::string glb_from(const Model& model) { return ModelWriter(model).write(); }

}  // namespace foveola::scenes
