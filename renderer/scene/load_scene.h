// From a file to a Scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/scene/kept_parts.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// How a scene file is read, where that is a matter of choice: see SceneSource's members of the
/// same names.
struct SceneReading {
  std::optional<LightUnits> light_units;
  bool strict = false;
  std::optional<double> time_s;
  std::string clip{};
  KeptSceneParts* kept = nullptr;  ///< where what was decoded is found and left, or null
};

/// Loads a glTF 2.0 file (.glb or .gltf). Throws Error naming the file and the JSON path of what
/// is wrong: missing or truncated file, no glTF, a required extension that is not supported, an
/// index out of range, a reference outside the file's own folder. What is optional and not
/// supported, geometry that had to be dropped, and, unless `reading` is strict, a texture that is
/// missing or cannot be read, becomes a warning in the scene.
Scene load_gltf(const std::filesystem::path& path, const SceneReading& reading = {});

/// Loads a Wavefront OBJ file and the material libraries and images in its folder that it names;
/// mtl_materials.h says what the libraries' statements mean. One mesh for each object (or group,
/// where there are no objects) and material. Throws Error naming the file and what is wrong; what
/// is missing of libraries and images is one only if `reading` is strict, else a warning.
Scene load_obj(const std::filesystem::path& path, const SceneReading& reading = {});

/// load_obj for a file whose name ends with ".obj" in either case, load_gltf for any other.
Scene load_scene_file(const std::filesystem::path& path, const SceneReading& reading = {});

/// load_scene_file, brought to metres, with the source's environment, sun and rectangle lights
/// added and its sizes of lights. A scene in other units looks the same, only larger or smaller.
/// Throws Error as well for what of these makes no sense. Its first warning is that the file is not
/// the one that the source was written for, if so.
Scene load_scene(const SceneSource& source, KeptSceneParts* kept = nullptr);

}  // namespace foveola
