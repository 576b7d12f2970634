#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/obj/file.h"
#include "renderer/scene/obj/meshes.h"
#include "renderer/scene/obj/mtl_file.h"
#include "renderer/scene/obj/mtl_materials.h"
#include "renderer/scene/obj/references.h"
#include "renderer/scene/obj/text_lines.h"
#include "renderer/scene/obj/textures.h"
#include "renderer/scene/prepare/rebase.h"
#include "renderer/scene/prepare/sanitised.h"
#include "renderer/scene/prepare/tangents.h"
#include "renderer/scene/references.h"
#include "renderer/scene/scene_hash.h"
#include "renderer/scene/warnings.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

constexpr const char* where_files_belong = "put the file into the folder of the OBJ file";

/// The file inside `folder` that `name` refers to; nullopt if it does not exist. Throws Error,
/// which begins with `where`, if it leads out of the folder.
std::optional<fs::path> file_if_there(const fs::path& folder, const std::string& name,
                                      const std::string& where) {
  try {
    return find_obj_reference(folder, name);
  } catch (const std::runtime_error& refusal) {
    throw Error(where, refusal.what(), where_files_belong);
  }
}

std::string missing(const std::string& name) {
  return fmt::format("refers to \"{}\", a file that does not exist", sanitised(name));
}

/// The files named by an mtllib statement: one file, whose name may have blanks, or several.
std::vector<std::string> library_names(const fs::path& folder, const std::string& statement) {
  std::vector<std::string> words;
  for (Statement left = statement_in(statement); !left.keyword.empty();
       left = statement_in(left.rest)) {
    words.emplace_back(left.keyword);
  }
  if (words.size() > 1) {
    try {
      return find_obj_reference(folder, statement) ? std::vector{statement} : words;
    } catch (const std::runtime_error&) {
      return words;
    }
  }
  return words;
}

/// A material of some library.
struct LibraryMaterial {
  MtlMaterial values;
  std::string folder;  ///< the library's folder, relative to the OBJ file's: "" or "sub/folder/"
  std::string place;   ///< for messages
};

struct Library {
  std::map<std::string, LibraryMaterial, std::less<>> materials;
  std::set<fs::path> files;
  std::set<fs::path> missing_files;
};

Library read_libraries(const fs::path& path, const fs::path& folder, const ObjFile& obj,
                       bool is_strict, Warnings& warnings) {
  Library library;
  ForeignReferences foreign;
  for (const std::string& statement : obj.material_libraries) {
    for (const std::string& name : library_names(folder, statement)) {
      const std::string where = path.string() + ": mtllib";
      const std::optional<fs::path> file = file_if_there(folder, name, where);
      if (!file && is_strict) {
        throw Error(where, missing(name), where_files_belong);
      }
      if (!file) {
        library.missing_files.insert(folder / local_reference(name));
        warnings.add("a material library is left out: " + sanitised(name) + " does not exist");
        continue;
      }
      foreign.add(name, warnings);
      if (!library.files.insert(*file).second) {
        continue;
      }
      const std::string local = local_reference(name);
      const std::string subfolder = local.substr(0, local.find_last_of('/') + 1);
      for (MtlMaterial& material : read_mtl_file(*file)) {
        const std::string key = material.name;
        library.materials.try_emplace(
            key, LibraryMaterial{std::move(material), subfolder,
                                 fmt::format("{}: {}", file->filename().string(), sanitised(key))});
      }
    }
  }
  return library;
}

/// Collects the used materials, each once.
class UsedMaterials {
 public:
  UsedMaterials(const Library& library, const fs::path& folder, bool is_strict, Warnings& warnings)
      : library_(library), folder_(folder), is_strict_(is_strict), warnings_(warnings) {}

  /// The index of the material with this name.
  std::size_t add(const std::string& name) {
    const auto [known, is_new] = index_of_.try_emplace(name, materials_.size());
    if (is_new) {
      materials_.push_back(read(name));
    }
    return known->second;
  }

  const Material& operator[](std::size_t index) const { return materials_[index]; }
  const ObjTextureSet& textures() const { return textures_; }
  const std::set<fs::path>& missing_textures() const { return missing_textures_; }
  /// Moves the materials, and the textures that they use and that can be decoded, into `scene`.
  /// kept: see ObjTextureSet::decode.
  void give_to(Scene& scene, KeptParts<Texels>* kept, const std::string& place) && {
    scene.materials = std::move(materials_);
    scene.textures = textures_.decode(scene.materials, kept, place, is_strict_, warnings_);
  }

 private:
  Material read(const std::string& name) {
    const auto found = library_.materials.find(name);
    if (found == library_.materials.end()) {
      if (!name.empty()) {
        warnings_.add("a material that no library describes is white", sanitised(name));
      }
      return default_obj_material();
    }
    const LibraryMaterial& source = found->second;
    const auto find_texture = [&](const std::string& texture) {
      const std::string reference = reference_from(source.folder, trimmed(texture));
      foreign_.add(reference, warnings_);
      const std::string local = local_reference(reference);
      const bool is_beside_mtl = is_foreign_reference(reference) &&
                                 file_if_there(folder_, source.folder + local, source.place);
      return texture_file(is_beside_mtl ? source.folder + local : local, source.place);
    };
    return material_of(source.values, find_texture, textures_, source.place, warnings_);
  }

  /// Empty, with a warning, for a missing file.
  fs::path texture_file(const std::string& name, const std::string& place) {
    const std::optional<fs::path> file = file_if_there(folder_, name, place);
    if (!file && is_strict_) {
      throw Error(place, missing(name), where_files_belong);
    }
    if (!file) {
      missing_textures_.insert(folder_ / name);
      warn_of_lost_texture(sanitised(name) + " does not exist", place, warnings_);
    }
    return file.value_or(fs::path());
  }

  const Library& library_;
  const fs::path& folder_;
  bool is_strict_;
  Warnings& warnings_;
  ObjTextureSet textures_;
  ForeignReferences foreign_;
  std::set<fs::path> missing_textures_;
  std::map<std::string, std::size_t, std::less<>> index_of_;
  std::vector<Material> materials_;
};

bool is_textured(const Material& material) {
  return material.base_color_texture.exists() || material.metallic_roughness_texture.exists() ||
         material.normal_texture.exists() || material.emissive_texture.exists() ||
         material.specular_color_texture.exists() || material.sheen_color_texture.exists();
}

std::vector<Mesh> meshes_of(const ObjFile& obj, UsedMaterials& materials, Warnings& warnings) {
  std::vector<Mesh> meshes;
  for (const ObjPart& part : obj.parts) {
    const std::size_t index = materials.add(part.material);
    const Material& material = materials[index];
    Mesh mesh = mesh_of(obj, part, is_textured(material), warnings);
    if (mesh.triangles.empty()) {
      continue;
    }
    mesh.material = static_cast<int>(index);
    if (material.normal_texture.exists() && !mesh.uv_sets.empty()) {
      add_tangents(mesh, 0, material.normal_texture.texture_from_mesh);
    }
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

std::string sha256_of_all(const ObjFile& obj, const std::set<fs::path>& files) {
  FileHashes hashes;
  for (const fs::path& file : files) {
    hashes[file] = sha256_of_file(file);
  }
  return scene_sha256(obj.sha256, hashes);
}

}  // namespace

Scene load_obj(const fs::path& path, const SceneReading& reading) {
  try {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    Warnings warnings;
    const ObjFile obj = read_obj_file(path, warnings);
    const Library library = read_libraries(path, folder, obj, reading.strict, warnings);
    UsedMaterials materials(library, folder, reading.strict, warnings);
    Scene scene;
    scene.meshes = meshes_of(obj, materials, warnings);
    rebase(scene);
    scene.files = materials.textures().files();
    scene.files.insert(library.files.begin(), library.files.end());
    scene.sha256 = sha256_of_all(obj, scene.files);
    scene.files.insert(path);
    for (const auto& missing : {library.missing_files, materials.missing_textures()}) {
      scene.files.insert(missing.begin(), missing.end());
    }
    std::move(materials).give_to(scene, reading.kept != nullptr ? &reading.kept->texels : nullptr,
                                 path.string());
    if (scene.meshes.empty()) {
      warnings.add("the scene has no triangles");
    }
    scene.warnings = warnings.lines();
    return scene;
  } catch (const Error&) {
    throw;
  } catch (const std::exception& exception) {
    throw Error(path.string(), fmt::format("cannot be read as OBJ ({})", exception.what()),
                "export it again");
  }
}

}  // namespace foveola
