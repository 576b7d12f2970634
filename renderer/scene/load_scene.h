// From a file to a Scene.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/scene_source.h"
#include "renderer/scene/scene.h"

namespace foveola {

/// Loads a glTF 2.0 file (.glb or .gltf). Throws Error naming the file and the JSON path of what
/// is wrong: missing or truncated file, no glTF, a required extension that is not supported, an
/// index out of range, a reference outside the file's own folder. What is optional and not
/// supported, and geometry that had to be dropped, becomes a warning in the scene.
Scene load_gltf(const std::filesystem::path& path);

/// load_gltf, with the source's environment and rectangle lights added.
Scene load_scene(const SceneSource& source);

/// An equirect EXR, HDR, PNG or JPEG image as environment. Throws Error if it cannot be read.
Environment load_environment(const std::filesystem::path& path);

}  // namespace foveola
