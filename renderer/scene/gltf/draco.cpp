#include "renderer/scene/gltf/draco.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf/added_buffer.h"
#include "renderer/scene/gltf/draco_mesh.h"
#include "renderer/scene/gltf/fault.h"

namespace foveola {
namespace {

using Json = nlohmann::json;
using Bytes = std::vector<unsigned char>;

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// What a triangle costs while its connectivity is decoded: Draco's corner table and what it keeps
/// beside it.
constexpr std::size_t bytes_per_triangle = 128;

int components_of(const std::string& type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
}

Bytes bytes_of(const std::vector<std::uint32_t>& indices) {
  Bytes bytes(indices.size() * sizeof(std::uint32_t));
  std::memcpy(bytes.data(), indices.data(), bytes.size());
  return bytes;
}

/// Decodes one primitive after the other.
class DracoDecompressor {
 public:
  DracoDecompressor(Json& document, std::vector<Bytes>& buffers)
      : document_(document), buffers_(buffers) {}

  void decompress(Json& primitive, const std::string& place) {
    const Json extension = primitive["extensions"][draco_extension];
    const std::string where = place + ".extensions." + draco_extension;
    const DracoMesh& mesh = mesh_of(extension["bufferView"].get<std::size_t>(), primitive, where);
    for (const auto& [name, id] : extension["attributes"].items()) {
      if (primitive["attributes"].contains(name)) {
        fill(primitive["attributes"][name].get<std::size_t>(), mesh, id.get<std::uint32_t>(),
             fmt::format("{}.attributes.{}", where, name));
      }
    }
    fill_indices(primitive, mesh, where);
    primitive["extensions"].erase(draco_extension);
  }

 private:
  /// Each buffer view is decoded once.
  const DracoMesh& mesh_of(std::size_t view_index, const Json& primitive,
                           const std::string& place) {
    if (const auto known = meshes_.find(view_index); known != meshes_.end()) {
      return *known->second;
    }
    const Json& view = document_["bufferViews"][view_index];
    const Bytes& buffer = buffers_[view["buffer"].get<std::size_t>()];
    const std::span<const unsigned char> bytes = std::span(buffer).subspan(
        view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
    encoded_bytes_ += bytes.size();
    const DracoLimits limits = limits_of(primitive, place);
    try {
      return *(meshes_[view_index] = std::make_unique<const DracoMesh>(bytes, limits));
    } catch (const std::runtime_error& fault) {
      throw GltfFault(place, fault.what());
    }
  }

  /// What the primitive's accessors state, if that is modest.
  DracoLimits limits_of(const Json& primitive, const std::string& place) {
    constexpr std::size_t most_bytes = std::size_t{1} << 31;
    const auto position = primitive["attributes"].find("POSITION");
    if (position == primitive["attributes"].end()) {
      throw GltfFault(place, "has no accessor for POSITION");
    }
    const std::size_t points = count_of(position->get<std::size_t>());
    const std::size_t triangles = primitive.contains("indices")
                                      ? count_of(primitive["indices"].get<std::size_t>()) / 3
                                      : points;
    take(triangles * bytes_per_triangle, place);
    return {.most_points = points,
            .most_triangles = triangles,
            .most_bytes = most_bytes - std::min(most_bytes, decoded_bytes_)};
  }

  std::size_t count_of(std::size_t accessor) const {
    return document_["accessors"][accessor]["count"].get<std::size_t>();
  }

  void take(std::size_t bytes, const std::string& place) {
    decoded_bytes_ += bytes;
    require_modest_gltf_memory(decoded_bytes_, encoded_bytes_, place);
  }

  void fill(std::size_t accessor_index, const DracoMesh& mesh, std::uint32_t id,
            const std::string& place) {
    if (!filled_.insert(accessor_index).second) {
      return;
    }
    Json& accessor = document_["accessors"][accessor_index];
    const int components = components_of(accessor["type"].get<std::string>());
    take(std::size_t{16} * mesh.points(), place);
    std::optional<Bytes> values = mesh.values(id, components, accessor["componentType"].get<int>());
    if (!values) {
      throw GltfFault(place, fmt::format("names attribute {}, which the mesh does not have", id));
    }
    set_content(accessor, mesh.points(), std::move(*values), place);
  }

  void fill_indices(Json& primitive, const DracoMesh& mesh, const std::string& place) {
    primitive["mode"] = 4;
    if (!primitive.contains("indices")) {
      primitive["indices"] = document_["accessors"].size();
      document_["accessors"].push_back({{"type", "SCALAR"}});
    }
    const auto index = primitive["indices"].get<std::size_t>();
    if (!filled_.insert(index).second) {
      return;
    }
    Json& accessor = document_["accessors"][index];
    accessor["componentType"] = 5125;
    take(std::size_t{12} * mesh.triangles(), place);
    set_content(accessor, std::size_t{3} * mesh.triangles(), bytes_of(mesh.indices()), place);
  }

  void set_content(Json& accessor, std::size_t count, Bytes bytes, const std::string& place) {
    if (bytes.empty()) {
      throw GltfFault(place, "holds a mesh without triangles");
    }
    accessor["count"] = count;
    accessor["bufferView"] = document_["bufferViews"].size();
    accessor.erase("byteOffset");
    const std::size_t size = bytes.size();
    document_["bufferViews"].push_back(
        {{"buffer", add_gltf_buffer(document_, buffers_, std::move(bytes))}, {"byteLength", size}});
  }

  Json& document_;
  std::vector<Bytes>& buffers_;
  std::map<std::size_t, std::unique_ptr<const DracoMesh>> meshes_;  ///< by buffer view
  std::set<std::size_t> filled_;                                    ///< accessors
  std::size_t decoded_bytes_ = 0;
  std::size_t encoded_bytes_ = 0;
};

}  // namespace

void decompress_draco(Json& document, std::vector<Bytes>& buffers) {
  if (!document.contains("meshes")) {
    return;
  }
  DracoDecompressor decompressor(document, buffers);
  for (std::size_t i = 0; i < document["meshes"].size(); ++i) {
    Json& primitives = document["meshes"][i]["primitives"];
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      if (primitives[k].contains("extensions") &&
          primitives[k]["extensions"].contains(draco_extension)) {
        decompressor.decompress(primitives[k], fmt::format("meshes[{}].primitives[{}]", i, k));
      }
    }
  }
}

}  // namespace foveola
