#include "scenes/fetch.h"

#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "scenes/download.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

/// The file's place, in a folder that is there now.
fs::path prepare_target(const Descriptor& descriptor) {
  const fs::path target = fetched_folder() / descriptor.file_name;
  std::error_code failure;
  fs::create_directories(target.parent_path(), failure);
  if (failure) {
    throw Error(target.parent_path().string(), "cannot be made: " + failure.message(),
                "set XDG_DATA_HOME to another folder");
  }
  require_writable(target);
  return target;
}

}  // namespace

fs::path fetch_from_web(const Descriptor& descriptor, const std::function<void(double)>& progress,
                        const std::stop_token& stop) {
  if (descriptor.address.empty()) {
    throw Error(descriptor.name, "has no address that it could be downloaded from",
                fmt::format("get it ({}) and give it with --from", descriptor.origin));
  }
  const fs::path target = prepare_target(descriptor);
  fs::path part = target;
  part += ".part";
  download(descriptor.address, part, descriptor.size_bytes, progress, stop);
  if (sha256_of_file(part) != descriptor.sha256) {
    fs::remove(part);
    throw Error(descriptor.address,
                "is not the file that the descriptor means: its SHA-256 differs",
                "it was changed or damaged on its way; try again, or get it by hand");
  }
  fs::rename(part, target);
  return target;
}

fs::path fetch_from_disk(const Descriptor& descriptor, const fs::path& file_or_folder) {
  const std::optional<fs::path> file = fs::is_directory(file_or_folder)
                                           ? find_in_folder(file_or_folder, descriptor.file_name)
                                           : std::optional(file_or_folder);
  if (!file) {
    throw Error(file_or_folder.string(),
                fmt::format("has no {} in it or one folder below", descriptor.file_name),
                "name the file itself");
  }
  const std::string content = read_file(*file);
  if (!descriptor.sha256.empty() && sha256(std::string_view(content)) != descriptor.sha256) {
    throw Error(file->string(),
                fmt::format("is not the {} that the descriptor means: its SHA-256 differs",
                            descriptor.file_name),
                "to use it all the same, name the file itself in place of the scene");
  }
  const fs::path target = prepare_target(descriptor);
  write_file(target, content);
  return target;
}

}  // namespace foveola::scenes
