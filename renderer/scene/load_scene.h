// Loads a Scene from a file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Options for reading a scene file: see SceneSource's members of the same names.
struct SceneReading {
  std::optional<LightUnits> light_units;
  bool strict = false;
  std::optional<double> time_s;
  std::string clip{};
  KeptSceneParts* kept = nullptr;  ///< stores decoded parts for reuse, or null
};

/// Loads a glTF 2.0 file (.glb or .gltf). Throws Error that names the file and the JSON path of the
/// fault: a missing or truncated file, not glTF, an unsupported required extension, an index out of
/// range, or a reference outside the file's folder. Unsupported optional extensions and dropped
/// geometry become warnings in the scene. Unless `reading` is strict, so do missing and unreadable
/// textures.
Scene load_gltf(const std::filesystem::path& path, const SceneReading& reading = {});

/// Loads a Wavefront OBJ file with its material libraries and images, which must be in its folder;
/// mtl_materials.h describes the libraries' statements. One mesh per object (or group, without
/// objects) and material. Throws Error that names the file and the fault. Missing libraries and
/// images are errors only if `reading` is strict, else warnings.
Scene load_obj(const std::filesystem::path& path, const SceneReading& reading = {});

/// load_obj for names that end with ".obj" in either case, load_gltf for all others.
Scene load_scene_file(const std::filesystem::path& path, const SceneReading& reading = {});

/// load_scene_file scaled to metres, with the source's environment, sun, rectangle lights and light
/// sizes. Equal scenes in other units differ only in size. Also throws Error for invalid values of
/// these. If the file is not the one that the source was written for, that is the first warning.
Scene load_scene(const SceneSource& source, KeptSceneParts* kept = nullptr);

}  // namespace foveola
