#include "scenes/find_scene.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "scenes/builtin_files.h"
#include "scenes/descriptor.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

SceneSource source_of(const Descriptor& descriptor) {
  SceneSource source = descriptor.source;
  if (descriptor.is_builtin) {
    source.file = require_builtin(descriptor.name);
    return source;
  }
  const FileSearch search = search_scene_path(descriptor.file_name);
  if (!search.file) {
    const std::string stand_in = descriptor.counterpart.empty()
                                     ? std::string()
                                     : ", or use the built-in " + descriptor.counterpart;
    throw Error(
        descriptor.name,
        fmt::format("its file {} is in no folder of $FOVEOLA_SCENE_PATH{}", descriptor.file_name,
                    in_brackets(search.obstacles)),
        fmt::format("see 'foveola scene fetch {}', or set FOVEOLA_SCENE_PATH to its folder{}",
                    descriptor.name, stand_in));
  }
  source.file = *search.file;
  return source;
}

/// Whether `file` takes the descriptor's viewpoint: a conversion of a real scene under its name, or
/// a copy of a built-in one. Anybody's church.glb is no copy of ours.
bool is_meant_by(const Descriptor& descriptor, const fs::path& file) {
  if (!descriptor.is_builtin) {
    return file.filename() == descriptor.file_name;
  }
  const bool has_its_name = file.filename() == descriptor.name + ".glb" ||
                            file.filename() == cached_builtin(descriptor.name).filename();
  return has_its_name && is_described_file(descriptor, file);
}

/// What its descriptor was written for is another file, but built alike.
SceneSource variant_of(const Descriptor& descriptor, std::uint32_t seed) {
  SceneSource source = descriptor.source;
  source.title += fmt::format(" (seed {})", seed);
  source.described_sha256.clear();
  return source;
}

SceneSource source_of_file(const fs::path& file) {
  SceneSource source;
  source.title = file.stem().string();
  for (const Descriptor& descriptor : all_descriptors().descriptors) {
    if (is_meant_by(descriptor, file)) {
      source = descriptor.source;
    } else if (const auto seed = variant_seed(descriptor.name, file)) {
      source = variant_of(descriptor, *seed);
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
  std::error_code failure;
  const fs::file_status status = fs::status(name_or_path, failure);
  if (fs::is_directory(status)) {
    throw Error(name_or_path, "is a folder, not a scene", "name a .glb, .gltf or .obj file in it");
  }
  if (failure == std::errc::permission_denied) {
    throw Error(name_or_path, "cannot be reached: " + failure.message(),
                "check the permissions of the folders above it");
  }
  std::error_code ignored;
  if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(name_or_path, ignored))) {
    throw Error(name_or_path, "is a link that leads nowhere", "mend the link");
  }
  if (!fs::exists(status)) {
    throw Error(name_or_path, "no such scene or file",
                fmt::format("the built-in scenes are {}; for the published study's own see "
                            "'foveola scene list' and set FOVEOLA_SCENE_PATH",
                            fmt::join(builtin_names(), ", ")));
  }
  if (!fs::is_regular_file(status)) {
    throw Error(name_or_path, "is not a regular file", "copy the scene into a file");
  }
  return source_of_file(name_or_path);
}

}  // namespace foveola::scenes
