#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/gltf/animation.h"
#include "renderer/scene/gltf/lights.h"
#include "renderer/scene/gltf/materials.h"
#include "renderer/scene/gltf/model.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/gltf/placing.h"
#include "renderer/scene/gltf_file/document.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_file/file.h"
#include "renderer/scene/gltf_mesh/accessor.h"
#include "renderer/scene/gltf_mesh/deformation.h"
#include "renderer/scene/gltf_mesh/geometry.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/prepare/sanitised.h"
#include "renderer/scene/warnings.h"

namespace foveola {
namespace {

constexpr const char* remedy = "export it again, or look at it with a glTF validator";

void warn_of_ignored_parts(const GltfModel& model, bool is_posed, Warnings& warnings) {
  for (const std::string& name : model.root().texts("extensionsUsed")) {
    if (!is_supported_extension(name)) {
      warnings.add(fmt::format("the extension {} is ignored{}", sanitised(name),
                               what_is_lost_without(name)));
    }
  }
  if (model.root().size("animations") > 0 && !is_posed) {
    warnings.add("animations are ignored; --time SECONDS applies them");
  }
}

/// For each material, whether a placed mesh uses it.
std::vector<bool> shown_materials(const GltfModel& model, const PlacedNodes& nodes) {
  std::vector<bool> is_shown(model.root().size("materials"), false);
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    for (const GltfPrimitive& primitive : model.meshes[i].primitives) {
      if (primitive.material >= 0 && !nodes.meshes[i].empty()) {
        is_shown[static_cast<std::size_t>(primitive.material)] = true;
      }
    }
  }
  return is_shown;
}

/// Skins may share joints, so that a small file can name any number.
void require_few_joints(std::size_t joints, const std::string& place) {
  constexpr std::size_t most = std::size_t{1} << 22;
  if (joints > most) {
    throw GltfFault(place, fmt::format("the scene has more than {} joints", most));
  }
}

std::string text_of(const TextureUse& use) {
  std::string text = fmt::format("uv set {}", use.uv_set);
  for (int column = 0; column < 3; ++column) {
    const Vec2 image = use.texture_from_mesh[column];
    text += fmt::format(" {} {}", image.x, image.y);
  }
  return text;
}

std::string text_of(const VertexNeeds& needs) {
  std::string text;
  for (const int set : needs.uv_sets) {
    text += fmt::format("{},", set);
  }
  return needs.normal_texture ? text + text_of(*needs.normal_texture) : text;
}

/// The bytes from the first element to the last, including those between; nullopt if incomplete.
std::optional<std::span<const unsigned char>> bytes_of(const GltfModel& model,
                                                       const GltfAccessor& accessor) {
  if (accessor.view < 0 || accessor.sparse) {
    return std::nullopt;
  }
  const GltfBufferView& view = model.views.at(static_cast<std::size_t>(accessor.view));
  const GltfBytes& buffer = model.buffers.at(view.buffer);
  const std::size_t size = accessor.element_size();
  const std::size_t stride = view.stride != 0 ? view.stride : size;
  const std::size_t length = (accessor.count - 1) * stride + size;
  const std::size_t end = accessor.offset + length;
  if (end > view.length || view.offset + end > buffer.size()) {
    return std::nullopt;
  }
  return std::span(buffer).subspan(view.offset + accessor.offset, length);
}

/// The primitives of one model, which must outlive this.
class PrimitiveDigests {
 public:
  explicit PrimitiveDigests(const GltfModel& model) : model_(model) {}

  /// A SHA-256 of all inputs of read_primitive(). nullopt for primitives with sparse accessors,
  /// accessors without a buffer view or with too little data, or morph targets.
  std::optional<std::string> of(const GltfPrimitive& primitive, const VertexNeeds& needs);

 private:
  /// Empty if there is none. Computed once per accessor, however many primitives share it.
  const std::string& of_accessor(int index);

  const GltfModel& model_;
  std::map<int, std::string> of_accessors_;
};

std::optional<std::string> PrimitiveDigests::of(const GltfPrimitive& primitive,
                                                const VertexNeeds& needs) {
  if (!primitive.targets.empty()) {
    return std::nullopt;
  }
  std::string text =
      fmt::format("mode {}\nneeds {}\n", static_cast<int>(primitive.mode), text_of(needs));
  const auto add = [&](const std::string& name, int accessor) {
    const std::string& digest = of_accessor(accessor);
    text += fmt::format("{} {}\n", name, digest);
    return !digest.empty();
  };
  for (const auto& [name, accessor] : primitive.attributes) {
    if (!add(name, accessor)) {
      return std::nullopt;
    }
  }
  if (primitive.indices >= 0 && !add("indices", primitive.indices)) {
    return std::nullopt;
  }
  return sha256(std::string_view(text));
}

const std::string& PrimitiveDigests::of_accessor(int index) {
  const auto [known, is_new] = of_accessors_.try_emplace(index);
  if (is_new) {
    const GltfAccessor& accessor = model_.accessors.at(static_cast<std::size_t>(index));
    if (const auto bytes = bytes_of(model_, accessor)) {
      const std::string layout = fmt::format(
          "{} {} {} {} {} {}", static_cast<int>(accessor.component), accessor.components,
          accessor.is_matrix, accessor.count, accessor.is_normalized,
          model_.views[static_cast<std::size_t>(accessor.view)].stride);
      Sha256 digest;
      digest.update(std::as_bytes(std::span(layout)));
      digest.update(std::as_bytes(*bytes));
      known->second = digest.hex();
    }
  }
  return known->second;
}

/// Reads primitives, or reuses kept ones.
class PrimitiveReader {
 public:
  PrimitiveReader(const GltfModel& model, KeptParts<Mesh>* kept, MemoryBudget& budget,
                  Warnings& warnings)
      : model_(model), kept_(kept), digests_(model), budget_(budget), warnings_(warnings) {}

  std::optional<Mesh> read(const GltfPrimitive& primitive, const VertexNeeds& needs,
                           const Deformation& deformation, const std::string& place) {
    // A skinned mesh differs between poses.
    const bool may_be_kept = kept_ != nullptr && deformation.joints.empty();
    const std::optional<std::string> digest =
        may_be_kept ? digests_.of(primitive, needs) : std::nullopt;
    if (const auto known = digest ? kept_->find(*digest) : nullptr) {
      budget_.take(bytes_of(*known), place);
      return *known;
    }
    const std::size_t cases_before = warnings_.count();
    std::optional<Mesh> mesh =
        read_primitive(model_, primitive, needs, deformation, place, budget_, warnings_);
    // Kept primitives would not repeat their warnings.
    if (digest && mesh && warnings_.count() == cases_before) {
      kept_->keep(*digest, std::make_shared<const Mesh>(*mesh));
    }
    return mesh;
  }

 private:
  const GltfModel& model_;
  KeptParts<Mesh>* kept_;
  PrimitiveDigests digests_;
  MemoryBudget& budget_;
  Warnings& warnings_;
};

/// Every mesh of a node, as the node deforms it.
std::vector<LocalMesh> read_meshes(const GltfModel& model, const PlacedNodes& nodes,
                                   const GltfMaterials& materials, KeptParts<Mesh>* kept,
                                   MemoryBudget& budget, Warnings& warnings) {
  PrimitiveReader reader(model, kept, budget, warnings);
  std::vector<LocalMesh> meshes(model.meshes.size());
  std::size_t joints = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    throw_if_work_stopped();
    if (nodes.meshes[i].empty()) {
      continue;
    }
    // A deformed mesh has only this node.
    const auto node = static_cast<std::size_t>(nodes.meshes[i].front().node);
    const Deformation deformation = deformation_of(model, model.nodes[node], nodes.world_from_node);
    joints += deformation.joints.size();
    require_few_joints(joints, fmt::format("nodes[{}].skin", node));
    const std::vector<GltfPrimitive>& primitives = model.meshes[i].primitives;
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      const std::size_t material = materials.index_of(primitives[k].material);
      std::optional<Mesh> mesh = reader.read(primitives[k], materials.needs[material], deformation,
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

/// Reuses the memory of the content kept from the previous version of the file.
GltfFile gltf_file_of(const std::filesystem::path& path, KeptSceneParts* kept) {
  std::string content;
  return read_gltf_file(path,
                        kept != nullptr && kept->places_instances ? kept->file_content : content);
}

Scene scene_of(GltfFile file, const SceneReading& reading) {
  GltfModel& model = file.model;
  Warnings warnings;
  warn_of_ignored_parts(model, reading.time_s.has_value(), warnings);
  check_sparse_accessors(model);
  if (reading.time_s) {
    pose_at(model, *reading.time_s, reading.clip, warnings);
  }
  separate_deformed_meshes(model);
  const PlacedNodes nodes = place_nodes(model, warnings);
  KeptSceneParts* const kept = reading.kept;
  GltfMaterials materials =
      read_materials(file, shown_materials(model, nodes), kept != nullptr ? &kept->texels : nullptr,
                     reading.strict, warnings);
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
  scene.clips = clip_names(model);
  scene.cameras = read_cameras(model, nodes.cameras, scene.origin, warnings);
  scene.lights = read_lights(model, nodes.lights, scene.origin, reading.light_units, warnings);
  if (scene.object_count() == 0) {
    warnings.add("the scene has no triangles");
  }
  scene.warnings = warnings.lines();
  const FileHashes beside = files_beside(file, std::move(materials.image_hashes));
  scene.sha256 = scene_sha256(file.sha256, beside);
  scene.files = std::move(materials.missing_files);
  for (const auto& [path, digest] : beside) {
    scene.files.insert(path);
  }
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const SceneReading& reading) {
  try {
    Scene scene = scene_of(gltf_file_of(path, reading.kept), reading);
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
