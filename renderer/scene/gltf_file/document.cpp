#include "renderer/scene/gltf_file/document.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_file/schema.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

using Json = nlohmann::json;

/// Printing JSON in messages is recursive.
constexpr int deepest_nesting = 64;

/// Line and column of the byte at `offset`, for people.
std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset > 0 ? offset - 1 : 0);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("line {}, column {}", line, before.size() - line_start + 1);
}

/// Depth of nested arrays and objects in `text`; meaningful if it is JSON.
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

/// Checked first: glTF 1 has another schema. Its files may have a number there.
void refuse_other_versions(const Json& document) {
  static const Json::json_pointer place("/asset/version");
  if (!document.is_object() || !document.contains(place)) {
    return;
  }
  const Json& version = document[place];
  const std::string text = version.is_string() ? version.get<std::string>() : version.dump();
  if (!text.starts_with("2.")) {
    throw GltfFault("asset.version",
                    fmt::format("is {}, but only glTF 2 can be read", sanitised(text)));
  }
}

void require_known_minimum(const Json& asset) {
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
                      fmt::format("the extension {} is not supported{}", sanitised(name),
                                  what_is_lost_without(name)));
    }
  }
}

}  // namespace

bool is_supported_extension(std::string_view name) {
  static constexpr std::array<std::string_view, 18> supported = {
      "EXT_mesh_gpu_instancing",    "KHR_node_visibility",
      "EXT_meshopt_compression",    "EXT_texture_webp",
      "KHR_draco_mesh_compression", "KHR_lights_punctual",
      "KHR_materials_clearcoat",    "KHR_materials_emissive_strength",
      "KHR_materials_ior",          "KHR_materials_pbrSpecularGlossiness",
      "KHR_materials_sheen",        "KHR_materials_specular",
      "KHR_materials_transmission", "KHR_materials_unlit",
      "KHR_materials_variants",     "KHR_materials_volume",
      "KHR_mesh_quantization",      "KHR_texture_transform"};
  return std::ranges::find(supported, name) != supported.end();
}

std::string what_is_lost_without(std::string_view name) {
  struct Loss {
    std::string_view extension;
    const char* what;
  };
  static constexpr std::array<Loss, 5> losses = {
      {{"KHR_materials_anisotropy", ": highlights are as wide along the grain as across it"},
       {"KHR_materials_diffuse_transmission", ": no light comes through leaves, paper and cloth"},
       {"KHR_materials_dispersion", ": glass refracts all colours alike"},
       {"KHR_materials_iridescence", ": thin films have no colours"},
       {"KHR_texture_basisu", ": KTX2 images are not read, export them as PNG or JPEG"}}};
  const auto* const known = std::ranges::find(losses, name, &Loss::extension);
  return known == losses.end() ? "" : known->what;
}

Json checked_gltf_document(std::string_view json) {
  Json document = parse(json);
  refuse_other_versions(document);
  require_schema(document);
  require_known_minimum(document["asset"]);
  require_known_extensions(document);
  return document;
}

}  // namespace foveola
