#include "renderer/scene/gltf_document.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/disarmed.h"
#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/json_rules.h"

namespace foveola {
namespace {

using Json = nlohmann::json;
using namespace json_rules;

constexpr Presence optional = Presence::optional;
constexpr Presence required = Presence::required;

/// tinygltf descends into extras and extensions recursively.
constexpr int deepest_nesting = 64;

/// Where in the text the byte number `offset` stands, for people.
std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset > 0 ? offset - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("line {}, column {}", line, before.size() - line_start + 1);
}

/// How deep arrays and objects are nested in `text`; meaningful if it is JSON.
int nesting_of(std::string_view text) {
  int depth = 0;
  int deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      }
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

Json parse(std::string_view text) {
  if (nesting_of(text) > deepest_nesting) {
    throw GltfFault("", fmt::format("the JSON is nested more than {} deep", deepest_nesting));
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw GltfFault(line_and_column(text, error.byte), "this is not JSON");
  } catch (const Json::out_of_range&) {
    throw GltfFault("", "the JSON has a number that is too large");
  }
}

/// The specification's tables of properties, as far as the loader reads them.
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
                   {"buffers", optional, array_of(buffer())},  // before the views of them
                   {"bufferViews", optional, array_of(buffer_view())},
                   {"materials", optional, array_of(material())},
                   {"textures", optional, array_of(texture())},
                   {"samplers", optional, array_of(sampler())},
                   {"images", optional, array_of(image())},
                   {"cameras", optional, array_of(camera())}});
  }

 private:
  Rule index(const std::string& array) const {
    const auto found = document_.find(array);
    const bool has_elements = found != document_.end() && found->is_array();
    return index_into(array, has_elements ? found->size() : 0);
  }
  Rule indices(const std::string& array) const { return array_of(index(array)); }

  static Rule byte_count(std::int64_t fewest) {
    return integer(fewest, std::numeric_limits<std::uint32_t>::max());
  }

  Rule node() const {
    return object({{"name", optional, text()},
                   {"children", optional, indices("nodes")},
                   {"mesh", optional, index("meshes")},
                   {"camera", optional, index("cameras")},
                   {"matrix", optional, numbers(16)},
                   {"translation", optional, numbers(3)},
                   {"rotation", optional, numbers(4)},
                   {"scale", optional, numbers(3)}});
  }

  Rule mesh() const {
    const Rule primitive = object({{"attributes", required, map_of(index("accessors"))},
                                   {"indices", optional, index("accessors")},
                                   {"material", optional, index("materials")},
                                   {"mode", optional, integer(0, 6)}});
    return object({{"name", optional, text()}, {"primitives", required, array_of(primitive, 1)}});
  }

  Rule accessor() const {
    return object(
        {{"bufferView", optional, index("bufferViews")},
         {"byteOffset", optional, byte_count(0)},
         {"componentType", required, one_of_integers({5120, 5121, 5122, 5123, 5125, 5126})},
         {"normalized", optional, boolean()},
         {"count", required, byte_count(1)},
         {"type", required, one_of({"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"})},
         {"sparse", optional, object({})}});
  }

  Rule buffer_view() const {
    const Rule shape = object({{"buffer", required, index("buffers")},
                               {"byteOffset", optional, byte_count(0)},
                               {"byteLength", required, byte_count(1)},
                               {"byteStride", optional, integer(4, 252)}});
    return [shape, this](const Json& value, const Place& place) {
      shape(value, place);
      const Json& buffer = document_["buffers"][value["buffer"].get<std::size_t>()];
      const std::uint64_t end =
          value.value("byteOffset", std::uint64_t{0}) + value["byteLength"].get<std::uint64_t>();
      if (const auto length = buffer["byteLength"].get<std::uint64_t>(); end > length) {
        throw GltfFault(place.path(), fmt::format("ends at byte {}, but buffers[{}] has {} bytes",
                                                  end, value["buffer"].dump(), length));
      }
    };
  }

  static Rule buffer() {
    return object({{"byteLength", required, byte_count(1)}, {"uri", optional, text()}});
  }

  Rule texture_info() const {
    return object({{"index", required, index("textures")}, {"texCoord", optional, integer(0, 15)}});
  }

  Rule material() const {
    const Rule metallic_roughness =
        object({{"baseColorFactor", optional, numbers(4)},
                {"baseColorTexture", optional, texture_info()},
                {"metallicFactor", optional, any_number()},
                {"roughnessFactor", optional, any_number()},
                {"metallicRoughnessTexture", optional, texture_info()}});
    const Rule emissive_strength = object({{"emissiveStrength", optional, number(0.0, 1e9)}});
    const Rule extensions =
        object({{"KHR_materials_emissive_strength", optional, emissive_strength}});
    return object({{"name", optional, text()},
                   {"pbrMetallicRoughness", optional, metallic_roughness},
                   {"normalTexture", optional, texture_info()},
                   {"emissiveTexture", optional, texture_info()},
                   {"emissiveFactor", optional, numbers(3)},
                   {"alphaMode", optional, one_of({"OPAQUE", "MASK", "BLEND"})},
                   {"alphaCutoff", optional, number(0.0, 1e9)},
                   {"doubleSided", optional, boolean()},
                   {"extensions", optional, extensions}});
  }

  static Rule any_number() {
    return number(std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  }

  Rule texture() const {
    return object(
        {{"sampler", optional, index("samplers")}, {"source", optional, index("images")}});
  }

  static Rule sampler() {
    const Rule wrap = one_of_integers({33071, 33648, 10497});
    return object({{"wrapS", optional, wrap}, {"wrapT", optional, wrap}});
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
    return object(
        {{"name", optional, text()}, {"type", required, one_of({"perspective", "orthographic"})}});
  }

  const Json& document_;
};

void require_version_2(const Json& asset) {
  const std::string version = asset["version"].get<std::string>();
  if (!version.starts_with("2.")) {
    throw GltfFault("asset.version",
                    fmt::format("is {}, but only glTF 2 can be read", disarmed(version)));
  }
  const auto minimum = asset.find("minVersion");
  if (minimum != asset.end() && *minimum != "2.0") {
    throw GltfFault("asset.minVersion", "demands a newer glTF than 2.0");
  }
}

void require_known_extensions(const Json& document) {
  const auto extensions = document.find("extensionsRequired");
  if (extensions == document.end()) {
    return;
  }
  for (std::size_t i = 0; i < extensions->size(); ++i) {
    if (const auto name = (*extensions)[i].get<std::string>(); !is_supported_extension(name)) {
      throw GltfFault(fmt::format("extensionsRequired[{}]", i),
                      fmt::format("the extension {} is not supported", disarmed(name)));
    }
  }
}

/// tinygltf makes a copy of the GLB's own chunk for every buffer without a uri.
void require_one_own_buffer(const Json& document) {
  const auto buffers = document.find("buffers");
  for (std::size_t i = 1; buffers != document.end() && i < buffers->size(); ++i) {
    if (!(*buffers)[i].contains("uri")) {
      throw GltfFault(fmt::format("buffers[{}].uri", i),
                      "is missing: only the first buffer may lie in the file itself");
    }
  }
}

/// tinygltf takes a data: uri of any other type for the name of a file.
bool is_readable_data_uri(std::string_view uri) {
  static constexpr std::array<std::string_view, 4> beginnings = {
      "data:application/octet-stream;base64,", "data:application/gltf-buffer;base64,",
      "data:image/png;base64,", "data:image/jpeg;base64,"};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return uri.starts_with(beginning); });
}

void append_references(const Json& document, const std::string& array,
                       std::vector<GltfReference>& references) {
  const auto items = document.find(array);
  if (items == document.end()) {
    return;
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const auto uri = (*items)[i].find("uri");
    if (uri == (*items)[i].end()) {
      continue;
    }
    GltfReference reference{.place = fmt::format("{}[{}].uri", array, i),
                            .uri = uri->get<std::string>()};
    if (!reference.uri.starts_with("data:")) {
      references.push_back(std::move(reference));
    } else if (!is_readable_data_uri(reference.uri)) {
      throw GltfFault(reference.place,
                      "is a data: uri of a type that is not supported; a buffer needs "
                      "application/octet-stream, an image image/png or image/jpeg, all in base64");
    }
  }
}

}  // namespace

bool is_supported_extension(std::string_view name) {
  return name == "KHR_materials_emissive_strength";
}

std::vector<GltfReference> check_gltf_document(std::string_view json) {
  const Json document = parse(json);
  Schema(document).document()(document, Place{});
  require_version_2(document["asset"]);
  require_known_extensions(document);
  require_one_own_buffer(document);
  std::vector<GltfReference> references;
  append_references(document, "buffers", references);
  append_references(document, "images", references);
  return references;
}

}  // namespace foveola
