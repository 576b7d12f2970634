#include "scenes/find_scene.h"

#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/file_access.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/similar_word.h"
#include "scenes/builtin.h"
#include "scenes/descriptor.h"
#include "scenes/descriptor_search.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

SceneSource source_of_programs_own(const Descriptor& descriptor) {
  SceneSource source = descriptor.source;
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

/// A descriptor from anywhere: its file is in its own folder, and it cannot name another.
SceneSource source_in_own_folder(const Descriptor& descriptor) {
  SceneSource source = descriptor.source;
  const fs::path folder = fs::absolute(descriptor.path).parent_path();
  try {
    source.file = confined_path(folder, descriptor.file_name);
  } catch (const std::runtime_error& reason) {
    throw Error(descriptor.path.string(),
                fmt::format("its scene '{}' is {}", descriptor.file_name, reason.what()),
                fmt::format("put the file into {}", folder.string()));
  }
  return source;
}

SceneSource source_of(const Descriptor& descriptor) {
  if (descriptor.is_builtin) {
    SceneSource source = descriptor.source;
    source.file = builtin_file(descriptor.name);
    return source;
  }
  return is_programs_own(descriptor) ? source_of_programs_own(descriptor)
                                     : source_in_own_folder(descriptor);
}

/// Returns whether `file` has the descriptor's viewpoint: a conversion of a real scene under its
/// name, or a copy of a built-in one. Another church.glb is not a copy of ours.
bool is_meant_by(const Descriptor& descriptor, const fs::path& file) {
  return descriptor.is_builtin ? file.filename() == builtin_file(descriptor.name).filename() &&
                                     is_described_file(descriptor, file)
                               : file.filename() == descriptor.file_name;
}

/// Returns the facts of the program's own descriptors about the file, if one means it.
SceneSource source_by_name_of_file(const fs::path& file) {
  SceneSource source;
  source.title = file.stem().string();
  for (const Descriptor& descriptor : all_descriptors().descriptors) {
    if (is_meant_by(descriptor, file)) {
      source = descriptor.source;
    }
  }
  return source;
}

SceneSource source_of_file(const fs::path& file) {
  SceneSource source;
  if (const std::optional<Descriptor> beside = descriptor_beside(file)) {
    source = beside->source;
    source.descriptor_beside = beside->path;
  } else {
    source = source_by_name_of_file(file);
  }
  source.name = file.string();
  source.file = file;
  return source;
}

void require_scene_file(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (fs::is_directory(status)) {
    throw Error(path.string(), "is a folder, not a scene", "name a .glb, .gltf or .obj file in it");
  }
  if (failure == std::errc::permission_denied) {
    throw Error(path.string(), "cannot be reached: " + failure.message(),
                "check the permissions of the folders above it");
  }
  std::error_code ignored;
  if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(path, ignored))) {
    throw Error(path.string(), "is a broken link", "correct the link");
  }
  if (!fs::exists(status)) {
    throw Error(
        path.string(), "is not a known scene or file",
        did_you_mean(path.string(), known_scene_names(),
                     fmt::format("the built-in scenes are {}; for the published study's own see "
                                 "'foveola scene list' and set FOVEOLA_SCENE_PATH",
                                 fmt::join(builtin_names(), ", "))));
  }
  if (!fs::is_regular_file(status)) {
    throw Error(path.string(), "is not a regular file", "copy the scene into a file");
  }
}

SceneSource source_at(const fs::path& path) {
  require_scene_file(path);
  return lower_case_extension(path) == ".toml" ? source_of(read_descriptor(path))
                                               : source_of_file(path);
}

/// Returns NAME.glb, NAME.gltf or NAME.obj in `folder`, the first that exists.
std::optional<fs::path> named_scene_file(const fs::path& folder, const std::string& name) {
  if (!is_scene_name(name)) {
    return std::nullopt;
  }
  for (const char* const extension : scene_extensions) {
    fs::path file = folder / (name + extension);
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) {
      return file;
    }
  }
  return std::nullopt;
}

/// Finds the scene `name` in `folder`, with or without a descriptor.
std::optional<SceneSource> find_in(const fs::path& folder, const std::string& name) {
  if (const std::optional<Descriptor> descriptor = find_descriptor_in(folder, name)) {
    return source_of(*descriptor);
  }
  const std::optional<fs::path> file = named_scene_file(folder, name);
  return file ? std::optional(source_of_file(*file)) : std::nullopt;
}

bool is_path(const std::string& name_or_path) {
  return !is_scene_name(name_or_path) || is_called_like_scene(name_or_path) ||
         lower_case_extension(name_or_path) == ".toml";
}

bool is_programs_protocols(const fs::path& folder) {
  std::error_code ignored;
  return fs::equivalent(folder, resource_folder() / "protocols", ignored);
}

}  // namespace

SceneSource find_scene(const std::string& name_or_path) {
  if (is_path(name_or_path)) {
    return source_at(name_or_path);
  }
  if (const std::optional<Descriptor> descriptor = find_users_descriptor(name_or_path)) {
    return source_of(*descriptor);
  }
  if (const std::optional<Descriptor> descriptor = find_descriptor(name_or_path)) {
    return source_of(*descriptor);
  }
  if (const std::optional<fs::path> file = named_scene_file(fetched_folder(), name_or_path)) {
    return source_of_file(*file);
  }
  return source_at(name_or_path);
}

SceneSource find_scene_beside(const std::string& name_or_path, const fs::path& folder) {
  if (is_path(name_or_path)) {
    return source_at(folder / name_or_path);  // An absolute path stays unchanged.
  }
  if (is_programs_protocols(folder)) {
    if (const std::optional<Descriptor> descriptor = find_descriptor(name_or_path)) {
      return source_of(*descriptor);
    }
  } else if (std::optional<SceneSource> source = find_in(folder, name_or_path)) {
    return *std::move(source);
  }
  return find_scene(name_or_path);
}

}  // namespace foveola::scenes
