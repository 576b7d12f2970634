#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/error.h"
#include "renderer/scene/gltf_accessor.h"
#include "renderer/scene/gltf_digest.h"
#include "renderer/scene/gltf_document.h"
#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/gltf_file.h"
#include "renderer/scene/gltf_geometry.h"
#include "renderer/scene/gltf_lights.h"
#include "renderer/scene/gltf_materials.h"
#include "renderer/scene/gltf_nodes.h"
#include "renderer/scene/gltf_placing.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/sanitised.h"
#include "renderer/scene/warnings.h"

namespace foveola {
namespace {

constexpr const char* remedy = "export it again, or look at it with a glTF validator";

void warn_of_what_is_ignored(const tinygltf::Model& model, Warnings& warnings) {
  for (const std::string& name : model.extensionsUsed) {
    if (!is_supported_extension(name)) {
      warnings.add("the extension " + sanitised(name) + " is ignored");
    }
  }
  if (!model.animations.empty()) {
    warnings.add("animations are ignored: everything stays in its first place");
  }
}

/// For each material, whether a placed mesh has it.
std::vector<bool> shown_materials(const tinygltf::Model& model, const PlacedNodes& nodes) {
  std::vector<bool> is_shown(model.materials.size(), false);
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    for (const tinygltf::Primitive& primitive : model.meshes[i].primitives) {
      if (primitive.material >= 0 && !nodes.meshes[i].empty()) {
        is_shown[static_cast<std::size_t>(primitive.material)] = true;
      }
    }
  }
  return is_shown;
}

/// Reads primitives, or finds them where they are kept.
class PrimitiveReader {
 public:
  PrimitiveReader(const tinygltf::Model& model, KeptParts<Mesh>* kept, MemoryBudget& budget,
                  Warnings& warnings)
      : model_(model), kept_(kept), digests_(model), budget_(budget), warnings_(warnings) {}

  std::optional<Mesh> read(const tinygltf::Primitive& primitive, const VertexNeeds& needs,
                           const std::string& place) {
    const std::optional<std::string> digest =
        kept_ != nullptr ? digests_.of(primitive, needs) : std::nullopt;
    if (const auto known = digest ? kept_->find(*digest) : nullptr) {
      budget_.take(bytes_of(*known), place);
      return *known;
    }
    const std::size_t cases_before = warnings_.cases();
    std::optional<Mesh> mesh = read_primitive(model_, primitive, needs, place, budget_, warnings_);
    // What was warned of is to be warned of again.
    if (digest && mesh && warnings_.cases() == cases_before) {
      kept_->keep(*digest, std::make_shared<const Mesh>(*mesh));
    }
    return mesh;
  }

 private:
  const tinygltf::Model& model_;
  KeptParts<Mesh>* kept_;
  PrimitiveDigests digests_;
  MemoryBudget& budget_;
  Warnings& warnings_;
};

/// Each mesh that a node shows.
std::vector<LocalMesh> read_meshes(const tinygltf::Model& model, const PlacedNodes& nodes,
                                   const GltfMaterials& materials, KeptParts<Mesh>* kept,
                                   MemoryBudget& budget, Warnings& warnings) {
  PrimitiveReader reader(model, kept, budget, warnings);
  std::vector<LocalMesh> meshes(model.meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::vector<tinygltf::Primitive>& primitives = model.meshes[i].primitives;
    for (std::size_t k = 0; k < primitives.size() && !nodes.meshes[i].empty(); ++k) {
      const std::size_t material = materials.index_of(primitives[k].material);
      std::optional<Mesh> mesh = reader.read(primitives[k], materials.needs[material],
                                             fmt::format("meshes[{}].primitives[{}]", i, k));
      if (mesh) {
        mesh->material = static_cast<int>(material);
        meshes[i].push_back(std::move(*mesh));
      }
    }
  }
  return meshes;
}

FileHashes files_beside(const GltfFile& file, FileHashes files) {
  files.insert(file.buffer_hashes.begin(), file.buffer_hashes.end());
  return files;
}

Scene scene_of(const GltfFile& file, std::optional<LightUnits> light_units, KeptSceneParts* kept) {
  const tinygltf::Model& model = *file.model;
  Warnings warnings;
  warn_of_what_is_ignored(model, warnings);
  check_sparse_accessors(model);
  const PlacedNodes nodes = place_nodes(model, warnings);
  GltfMaterials materials = read_materials(file, shown_materials(model, nodes),
                                           kept != nullptr ? &kept->texels : nullptr, warnings);
  MemoryBudget budget(model);
  std::vector<LocalMesh> meshes = read_meshes(
      model, nodes, materials, kept != nullptr ? &kept->meshes : nullptr, budget, warnings);

  Scene scene;
  scene.origin = choose_origin(meshes, nodes.meshes);
  add_meshes(
      scene, std::move(meshes), nodes, model,
      kept != nullptr && kept->places_instances ? Placing::instances : Placing::copies_where_few,
      budget, warnings);
  scene.materials = std::move(materials.materials);
  scene.textures = std::move(materials.textures);
  scene.cameras = read_cameras(model, nodes.cameras, scene.origin, warnings);
  scene.lights = read_lights(model, nodes.lights, scene.origin, light_units, warnings);
  if (scene.object_count() == 0) {
    warnings.add("the scene has no triangles");
  }
  scene.warnings = warnings.lines();
  const FileHashes beside = files_beside(file, std::move(materials.image_hashes));
  scene.sha256 = scene_sha256(file.sha256, beside);
  for (const auto& [path, digest] : beside) {
    scene.files.insert(path);
  }
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, std::optional<LightUnits> light_units,
                KeptSceneParts* kept) {
  try {
    Scene scene = scene_of(read_gltf_file(path), light_units, kept);
    scene.files.insert(path);
    return scene;
  } catch (const Error&) {
    throw;
  } catch (const GltfFault& fault) {
    const std::string where = fault.where().empty() ? "" : ": " + fault.where();
    throw Error(path.string() + where, fault.what(), remedy);
  } catch (const std::exception& exception) {
    throw Error(path.string(), fmt::format("cannot be read as glTF ({})", exception.what()),
                remedy);
  }
}

}  // namespace foveola
