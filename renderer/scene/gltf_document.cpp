#include "renderer/scene/gltf_document.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/gltf_schema.h"
#include "renderer/scene/sanitised.h"

namespace foveola {
namespace {

using Json = nlohmann::json;

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

void require_version_2(const Json& asset) {
  const std::string version = asset["version"].get<std::string>();
  if (!version.starts_with("2.")) {
    throw GltfFault("asset.version",
                    fmt::format("is {}, but only glTF 2 can be read", sanitised(version)));
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
                      fmt::format("the extension {} is not supported", sanitised(name)));
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

void append_references(const Json& document, const std::string& array, bool are_images,
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
                            .uri = uri->get<std::string>(),
                            .is_image = are_images};
    if (!reference.uri.starts_with("data:") ||
        (are_images && reference.uri.starts_with(jpg_data_uri))) {
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
  static constexpr std::array<std::string_view, 11> supported = {
      "KHR_lights_punctual",        "KHR_materials_clearcoat", "KHR_materials_emissive_strength",
      "KHR_materials_ior",          "KHR_materials_sheen",     "KHR_materials_specular",
      "KHR_materials_transmission", "KHR_materials_unlit",     "KHR_materials_volume",
      "KHR_mesh_quantization",      "KHR_texture_transform"};
  return std::find(supported.begin(), supported.end(), name) != supported.end();
}

std::vector<GltfReference> check_gltf_document(std::string_view json) {
  const Json document = parse(json);
  require_schema(document);
  require_version_2(document["asset"]);
  require_known_extensions(document);
  require_one_own_buffer(document);
  std::vector<GltfReference> references;
  append_references(document, "buffers", false, references);
  append_references(document, "images", true, references);
  return references;
}

}  // namespace foveola
