#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <tiny_gltf.h>

#include "renderer/base/error.h"
#include "renderer/scene/disarmed.h"
#include "renderer/scene/gltf_document.h"
#include "renderer/scene/gltf_fault.h"
#include "renderer/scene/gltf_file.h"
#include "renderer/scene/gltf_geometry.h"
#include "renderer/scene/gltf_materials.h"
#include "renderer/scene/gltf_nodes.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {
namespace {

constexpr const char* remedy = "export it again, or look at it with a glTF validator";

/// Instances are copies, so a small file can ask for any number of triangles.
constexpr std::size_t most_triangles = std::size_t{1} << 26;

void warn_of_what_is_ignored(const tinygltf::Model& model, Warnings& warnings) {
  for (const std::string& name : model.extensionsUsed) {
    if (!is_supported_extension(name)) {
      warnings.add("the extension " + disarmed(name) + " is ignored");
    }
  }
  if (!model.animations.empty()) {
    warnings.add("animations are ignored: everything stays in its first place");
  }
}

/// Reads each primitive once, and adds a baked copy of it for each instance of its mesh.
class MeshBaker {
 public:
  MeshBaker(const tinygltf::Model& model, const GltfMaterials& materials, Warnings& warnings)
      : model_(model), materials_(materials), warnings_(warnings) {}

  void add(std::size_t mesh_index, const std::vector<MeshInstance>& instances) {
    const tinygltf::Mesh& source = model_.meshes[mesh_index];
    for (std::size_t i = 0; i < source.primitives.size() && !instances.empty(); ++i) {
      add(source.primitives[i], instances, fmt::format("meshes[{}].primitives[{}]", mesh_index, i));
    }
  }

  std::vector<Mesh> take() && { return std::move(meshes_); }

 private:
  void add(const tinygltf::Primitive& primitive, const std::vector<MeshInstance>& instances,
           const std::string& place) {
    const std::size_t material = primitive.material >= 0
                                     ? static_cast<std::size_t>(primitive.material)
                                     : materials_.materials.size() - 1;
    std::optional<Mesh> local =
        read_primitive(model_, primitive, materials_.uv_sets[material], place, warnings_);
    if (!local) {
      return;
    }
    local->material = static_cast<int>(material);
    count_triangles(local->triangles.size() * instances.size(), place);
    for (std::size_t i = 0; i + 1 < instances.size(); ++i) {
      add_baked(*local, instances[i], place);
    }
    add_baked(std::move(*local), instances.back(), place);
  }

  void count_triangles(std::size_t count, const std::string& place) {
    triangles_ += count;
    if (triangles_ > most_triangles) {
      throw GltfFault(place, fmt::format("brings the scene, with every instance copied, to more "
                                         "than {} triangles",
                                         most_triangles));
    }
  }

  void add_baked(Mesh mesh, const MeshInstance& instance, const std::string& place) {
    mesh.name = instance.name;
    bake(mesh, instance.world_from_local, place, warnings_);
    if (!mesh.triangles.empty()) {
      meshes_.push_back(std::move(mesh));
    }
  }

  const tinygltf::Model& model_;
  const GltfMaterials& materials_;
  Warnings& warnings_;
  std::vector<Mesh> meshes_;
  std::size_t triangles_ = 0;
};

Scene scene_of(const GltfFile& file) {
  const tinygltf::Model& model = *file.model;
  Warnings warnings;
  warn_of_what_is_ignored(model, warnings);
  PlacedNodes placed = place_nodes(model, warnings);
  GltfMaterials materials = read_materials(model, warnings);
  MeshBaker baker(model, materials, warnings);
  for (std::size_t i = 0; i < placed.instances.size(); ++i) {
    baker.add(i, placed.instances[i]);
  }
  Scene scene;
  scene.meshes = std::move(baker).take();
  scene.materials = std::move(materials.materials);
  scene.textures = std::move(materials.textures);
  scene.cameras = std::move(placed.cameras);
  if (scene.meshes.empty()) {
    warnings.add("the scene has no triangles");
  }
  scene.warnings = warnings.lines();
  scene.sha256 = file.sha256;
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path) {
  try {
    return scene_of(read_gltf_file(path));
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
