#include "scenes/find_scene.h"

#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "scenes/builtin.h"
#include "scenes/descriptor.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

SceneSource source_of(const Descriptor& descriptor) {
  SceneSource source = descriptor.source;
  if (descriptor.is_builtin) {
    source.file = require_builtin(descriptor.name);
    return source;
  }
  const std::optional<fs::path> file = find_real_file(descriptor);
  if (!file) {
    const std::string stand_in = descriptor.counterpart.empty()
                                     ? std::string()
                                     : ", or use the built-in " + descriptor.counterpart;
    throw Error(
        descriptor.name,
        fmt::format("its file {} is in no folder of $FOVEOLA_SCENE_PATH", descriptor.file_name),
        fmt::format("get it ({}) with 'foveola scene fetch', or set FOVEOLA_SCENE_PATH to its "
                    "folder{}",
                    descriptor.origin, stand_in));
  }
  source.file = *file;
  return source;
}

/// Whether `file` is the descriptor's scene, by its name.
bool is_named_by(const Descriptor& descriptor, const fs::path& file) {
  if (descriptor.is_builtin) {
    return file.filename() == descriptor.name + ".glb" ||
           file.filename() == cached_builtin(descriptor.name).filename();
  }
  return file.filename() == descriptor.file_name;
}

SceneSource source_of_file(const fs::path& file) {
  SceneSource source;
  source.title = file.stem().string();
  for (const Descriptor& descriptor : all_descriptors()) {
    if (is_named_by(descriptor, file)) {
      source = descriptor.source;
    }
  }
  source.name = file.string();
  source.file = file;
  return source;
}

}  // namespace

SceneSource find_scene(const std::string& name_or_path) {
  if (const std::optional<Descriptor> descriptor = find_descriptor(name_or_path)) {
    return source_of(*descriptor);
  }
  if (fs::is_directory(name_or_path)) {
    throw Error(name_or_path, "is a folder, not a scene", "name a .glb, .gltf or .obj file in it");
  }
  if (!fs::exists(name_or_path)) {
    throw Error(name_or_path, "no such scene or file",
                fmt::format("the built-in scenes are {}; for the published study's own see "
                            "'foveola scene list' and set FOVEOLA_SCENE_PATH",
                            fmt::join(builtin_names(), ", ")));
  }
  return source_of_file(name_or_path);
}

}  // namespace foveola::scenes
