#include "scenes/fetch.h"

#include <system_error>

#include <fmt/format.h>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "scenes/builtin_files.h"
#include "scenes/download.h"
#include "scenes/file_search.h"

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

/// Whether the descriptor's own file lies at `target` already.
bool is_there(const Descriptor& descriptor, const fs::path& target) {
  std::error_code ignored;
  return fs::is_regular_file(target, ignored) && is_described_file(descriptor, target);
}

/// The file that --from means. Throws Error if there is none.
fs::path named_file(const Descriptor& descriptor, const fs::path& file_or_folder) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file_or_folder, ignored);
  if (fs::is_directory(status)) {
    const FileSearch search = search_folder(file_or_folder, descriptor.file_name);
    if (!search.file) {
      throw Error(file_or_folder.string(),
                  fmt::format("has no {} in it or one folder below{}", descriptor.file_name,
                              in_brackets(search.obstacles)),
                  "name the file itself");
    }
    return *search.file;
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw Error(file_or_folder.string(), "is not a regular file", "copy the scene into a file");
  }
  return file_or_folder;
}

void require_accepted(const Descriptor& descriptor, const fs::path& file,
                      const std::string& content, Accept accept) {
  if (accept == Accept::any_glb) {
    if (!is_whole_glb(file)) {
      throw Error(file.string(), "is no glTF binary, or is cut off", "export it as .glb");
    }
  } else if (!descriptor.sha256.empty() && sha256(std::string_view(content)) != descriptor.sha256) {
    throw Error(file.string(),
                fmt::format("is not the {} that the descriptor means: its SHA-256 differs",
                            descriptor.file_name),
                "to take a conversion of your own in its place, add --unverified");
  }
}

}  // namespace

fs::path fetch_from_web(const Descriptor& descriptor, const std::function<void(double)>& progress,
                        const std::stop_token& stop) {
  if (descriptor.address.empty()) {
    throw Error(descriptor.name, "its file has no address that it could be downloaded from",
                fmt::format("get the scene from {}, convert it to .glb and give it with --from "
                            "FILE.glb --unverified",
                            descriptor.origin));
  }
  const fs::path target = prepare_target(descriptor);
  if (is_there(descriptor, target)) {
    return target;
  }
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

fs::path fetch_from_disk(const Descriptor& descriptor, const fs::path& file_or_folder,
                         Accept accept) {
  const fs::path file = named_file(descriptor, file_or_folder);
  const std::string content = read_file(file);
  require_accepted(descriptor, file, content, accept);
  const fs::path target = prepare_target(descriptor);
  write_file(target, content);
  return target;
}

}  // namespace foveola::scenes
