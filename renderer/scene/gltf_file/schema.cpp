#include "renderer/scene/gltf_file/schema.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_file/json_rules.h"

namespace foveola {
namespace {

using Json = nlohmann::json;
using namespace json_rules;

constexpr Presence optional = Presence::optional;
constexpr Presence required = Presence::required;

class Schema {
 public:
  explicit Schema(const Json& document) : document_(document) {}

  Rule document() const {
    return object({{"asset", required, object({{"version", required, text()}})},
                   {"extensionsUsed", optional, array_of(text())},
                   {"extensionsRequired", optional, array_of(text())},
                   {"scene", optional, index("scenes")},
                   {"scenes", optional, array_of(object({{"nodes", optional, indices("nodes")}}))},
                   {"nodes", optional, array_of(node())},
                   {"meshes", optional, array_of(mesh())},
                   {"accessors", optional, array_of(accessor())},
                   {"buffers", optional, array_of(buffer())},  // before their views
                   {"bufferViews", optional, array_of(buffer_view())},
                   {"materials", optional, array_of(material())},
                   {"textures", optional, array_of(texture())},
                   {"samplers", optional, array_of(sampler())},
                   {"images", optional, array_of(image())},
                   {"cameras", optional, array_of(camera())},
                   {"skins", optional, array_of(skin())},
                   {"animations", optional, array_of(animation())},
                   {"extensions", optional,
                    object({{"KHR_lights_punctual", optional,
                             object({{"lights", required, array_of(light())}})}})}});
  }

 private:
  Rule index(const std::string& array) const {
    const auto found = document_.find(array);
    const bool has_elements = found != document_.end() && found->is_array();
    return index_into(array, has_elements ? found->size() : 0);
  }
  Rule indices(const std::string& array) const { return array_of(index(array)); }

  Rule light_index() const {
    static const Json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    const bool has_lights = document_.contains(lights) && document_[lights].is_array();
    return index_into("lights", has_lights ? document_[lights].size() : 0);
  }

  /// A number of 32 bits, not below `fewest`.
  static Rule integer_from(std::int64_t minimum) {
    return integer(minimum, std::numeric_limits<std::uint32_t>::max());
  }

  Rule node() const {
    return object(
        {{"name", optional, text()},
         {"children", optional, indices("nodes")},
         {"mesh", optional, index("meshes")},
         {"camera", optional, index("cameras")},
         {"skin", optional, index("skins")},
         {"weights", optional, array_of(any_number())},
         {"matrix", optional, numbers(16)},
         {"translation", optional, numbers(3)},
         {"rotation", optional, numbers(4)},
         {"scale", optional, numbers(3)},
         {"extensions", optional,
          object(
              {{"KHR_lights_punctual", optional, object({{"light", required, light_index()}})},
               {"EXT_mesh_gpu_instancing", optional,
                object({{"attributes", required, map_of(index("accessors"))}})},
               {"KHR_node_visibility", optional, object({{"visible", optional, boolean()}})}})}});
  }

  Rule mesh() const {
    const Rule draco = object({{"bufferView", required, index("bufferViews")},
                               {"attributes", required, map_of(integer_from(0))}});
    const Rule primitive = object(
        {{"attributes", required, map_of(index("accessors"))},
         {"indices", optional, index("accessors")},
         {"material", optional, index("materials")},
         {"mode", optional, integer(0, 6)},
         {"targets", optional, array_of(map_of(index("accessors")))},
         {"extensions", optional, object({{"KHR_draco_mesh_compression", optional, draco}})}});
    return object({{"name", optional, text()},
                   {"weights", optional, array_of(any_number())},
                   {"primitives", required, array_of(primitive, 1)}});
  }

  Rule skin() const {
    return object({{"joints", required, array_of(index("nodes"), 1)},
                   {"inverseBindMatrices", optional, index("accessors")},
                   {"skeleton", optional, index("nodes")}});
  }

  Rule animation() const {
    const Rule target = object({{"node", optional, index("nodes")}, {"path", required, text()}});
    const Rule channel = object({{"sampler", required, integer(0, std::numeric_limits<int>::max())},
                                 {"target", required, target}});
    const Rule sampler =
        object({{"input", required, index("accessors")},
                {"output", required, index("accessors")},
                {"interpolation", optional, one_of({"LINEAR", "STEP", "CUBICSPLINE"})}});
    const Rule shape = object(
        {{"channels", required, array_of(channel)}, {"samplers", required, array_of(sampler)}});
    return [shape](const Json& value, const Place& place) {
      shape(value, place);
      const Rule sampler_index = index_into("samplers", value["samplers"].size());
      const Rule channels = array_of(object({{"sampler", required, sampler_index}}));
      channels(value["channels"], Place{.parent = &place, .key = "channels"});
    };
  }

  Rule accessor() const {
    const Rule shape = object(
        {{"bufferView", optional, index("bufferViews")},
         {"byteOffset", optional, integer_from(0)},
         {"componentType", required, one_of_integers({5120, 5121, 5122, 5123, 5125, 5126})},
         {"normalized", optional, boolean()},
         {"count", required, integer_from(1)},
         {"type", required, one_of({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"})},
         {"sparse", optional, sparse()}});
    return [shape](const Json& value, const Place& place) {
      shape(value, place);
      if (value.contains("sparse") && value["sparse"]["count"] > value["count"]) {
        throw GltfFault(place.path() + ".sparse.count", "is larger than the accessor's count");
      }
    };
  }

  Rule sparse() const {
    const Rule index_type = one_of_integers({5121, 5123, 5125});
    return object({{"count", required, integer_from(1)},
                   {"indices", required,
                    object({{"bufferView", required, index("bufferViews")},
                            {"byteOffset", optional, integer_from(0)},
                            {"componentType", required, index_type}})},
                   {"values", required,
                    object({{"bufferView", required, index("bufferViews")},
                            {"byteOffset", optional, integer_from(0)}})}});
  }

  Rule buffer_view() const {
    const Rule shape = object(
        {{"buffer", required, index("buffers")},
         {"byteOffset", optional, integer_from(0)},
         {"byteLength", required, integer_from(1)},
         {"byteStride", optional, integer(4, 252)},
         {"extensions", optional, object({{"EXT_meshopt_compression", optional, meshopt()}})}});
    return [shape, this](const Json& value, const Place& place) {
      shape(value, place);
      if (value.value("byteStride", 4) % 4 != 0) {
        throw GltfFault(place.path() + ".byteStride", "must be a multiple of 4");
      }
      // `buffers` has been checked: see document().
      const Json& buffer = document_["buffers"][value["buffer"].get<std::size_t>()];
      const std::uint64_t end =
          value.value("byteOffset", std::uint64_t{0}) + value["byteLength"].get<std::uint64_t>();
      if (const auto length = buffer["byteLength"].get<std::uint64_t>(); end > length) {
        throw GltfFault(place.path(), fmt::format("ends at byte {}, but buffers[{}] has {} bytes",
                                                  end, value["buffer"].dump(), length));
      }
    };
  }

  Rule meshopt() const {
    return object(
        {{"buffer", required, index("buffers")},
         {"byteOffset", optional, integer_from(0)},
         {"byteLength", required, integer_from(1)},
         {"byteStride", required, integer(1, 256)},
         {"count", required, integer_from(1)},
         {"mode", required, one_of({"ATTRIBUTES", "TRIANGLES", "INDICES"})},
         {"filter", optional, one_of({"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"})}});
  }

  static Rule buffer() {
    const Rule meshopt = object({{"fallback", optional, boolean()}});
    return object(
        {{"byteLength", required, integer_from(1)},
         {"uri", optional, text()},
         {"extensions", optional, object({{"EXT_meshopt_compression", optional, meshopt}})}});
  }

  std::vector<Property> texture_info_properties() const {
    const Rule tex_coord = integer(0, 15);
    const Rule transform = object({{"offset", optional, numbers(2)},
                                   {"rotation", optional, any_number()},
                                   {"scale", optional, numbers(2)},
                                   {"texCoord", optional, tex_coord}});
    return {{"index", required, index("textures")},
            {"texCoord", optional, tex_coord},
            {"extensions", optional, object({{"KHR_texture_transform", optional, transform}})}};
  }
  Rule texture_info() const { return object(texture_info_properties()); }
  Rule normal_texture_info() const {
    std::vector<Property> properties = texture_info_properties();
    properties.push_back({"scale", optional, any_number()});
    return object(std::move(properties));
  }

  Rule material() const {
    const Rule metallic_roughness =
        object({{"baseColorFactor", optional, numbers(4)},
                {"baseColorTexture", optional, texture_info()},
                {"metallicFactor", optional, any_number()},
                {"roughnessFactor", optional, any_number()},
                {"metallicRoughnessTexture", optional, texture_info()}});
    return object({{"name", optional, text()},
                   {"pbrMetallicRoughness", optional, metallic_roughness},
                   {"normalTexture", optional, normal_texture_info()},
                   {"emissiveTexture", optional, texture_info()},
                   {"emissiveFactor", optional, numbers(3)},
                   {"alphaMode", optional, one_of({"OPAQUE", "MASK", "BLEND"})},
                   {"alphaCutoff", optional, number(0.0, 1e9)},
                   {"doubleSided", optional, boolean()},
                   {"extensions", optional, material_extensions()}});
  }

  Rule material_extensions() const {
    const Rule factor = any_number();
    const Rule color = numbers(3);
    const Rule texture = texture_info();
    std::vector<Property> normal_texture = texture_info_properties();
    normal_texture.push_back({"scale", optional, any_number()});
    return object(
        {{"KHR_materials_clearcoat", optional,
          object({{"clearcoatFactor", optional, factor},
                  {"clearcoatTexture", optional, texture},
                  {"clearcoatRoughnessFactor", optional, factor},
                  {"clearcoatRoughnessTexture", optional, texture},
                  {"clearcoatNormalTexture", optional, object(std::move(normal_texture))}})},
         {"KHR_materials_emissive_strength", optional,
          object({{"emissiveStrength", optional, factor}})},
         {"KHR_materials_pbrSpecularGlossiness", optional,
          object({{"diffuseFactor", optional, numbers(4)},
                  {"diffuseTexture", optional, texture},
                  {"specularFactor", optional, color},
                  {"glossinessFactor", optional, factor},
                  {"specularGlossinessTexture", optional, texture}})},
         {"KHR_materials_ior", optional, object({{"ior", optional, factor}})},
         {"KHR_materials_sheen", optional,
          object({{"sheenColorFactor", optional, color},
                  {"sheenColorTexture", optional, texture},
                  {"sheenRoughnessFactor", optional, factor},
                  {"sheenRoughnessTexture", optional, texture}})},
         {"KHR_materials_specular", optional,
          object({{"specularFactor", optional, factor},
                  {"specularTexture", optional, texture},
                  {"specularColorFactor", optional, color},
                  {"specularColorTexture", optional, texture}})},
         {"KHR_materials_transmission", optional,
          object({{"transmissionFactor", optional, factor},
                  {"transmissionTexture", optional, texture}})},
         {"KHR_materials_unlit", optional, object({})},
         {"KHR_materials_volume", optional,
          object({{"thicknessFactor", optional, factor},
                  {"attenuationDistance", optional, factor},
                  {"attenuationColor", optional, color}})}});
  }

  static Rule any_number() {
    return number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  }

  Rule texture() const {
    const Rule other_source = object({{"source", optional, index("images")}});
    return object({{"sampler", optional, index("samplers")},
                   {"source", optional, index("images")},
                   {"extensions", optional,
                    object({{"EXT_texture_webp", optional, other_source},
                            {"KHR_texture_basisu", optional, other_source}})}});
  }

  static Rule sampler() {
    const Rule wrap = one_of_integers({33071, 33648, 10497});
    return object({{"wrapS", optional, wrap},
                   {"wrapT", optional, wrap},
                   {"magFilter", optional, one_of_integers({9728, 9729})},
                   {"minFilter", optional, one_of_integers({9728, 9729, 9984, 9985, 9986, 9987})}});
  }

  Rule image() const {
    const Rule shape =
        object({{"uri", optional, text()}, {"bufferView", optional, index("bufferViews")}});
    return [shape](const Json& value, const Place& place) {
      shape(value, place);
      if (value.contains("uri") == value.contains("bufferView")) {
        throw GltfFault(place.path(), "must have either a uri or a bufferView");
      }
    };
  }

  static Rule camera() {
    const Rule lens =
        object({{"yfov", optional, any_number()}, {"aspectRatio", optional, any_number()}});
    return object({{"name", optional, text()},
                   {"type", required, one_of({"perspective", "orthographic"})},
                   {"perspective", optional, lens}});
  }

  static Rule light() {
    const Rule spot = object(
        {{"innerConeAngle", optional, any_number()}, {"outerConeAngle", optional, any_number()}});
    const Rule shape = object({{"name", optional, text()},
                               {"type", required, text()},
                               {"color", optional, numbers(3)},
                               {"intensity", optional, any_number()},
                               {"range", optional, any_number()},
                               {"spot", optional, spot}});
    return [shape](const Json& value, const Place& place) {
      shape(value, place);
      if (value["type"] == "spot" && !value.contains("spot")) {
        throw GltfFault(place.path() + ".spot", "is missing");
      }
    };
  }

  const Json& document_;
};

}  // namespace

void require_schema(const nlohmann::json& document) {
  Schema(document).document()(document, Place{});
}

}  // namespace foveola
