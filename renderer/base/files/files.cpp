#include "renderer/base/files/files.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/work/programs.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// The value of an environment variable as a path; empty if it is unset or empty.
fs::path path_from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? fs::path(value) : fs::path();
}

/// In the system's temporary folder, where another user may have created this name. Throws Error
/// unless it is this user's alone.
fs::path own_temporary_folder() {
  const fs::path folder = fs::temp_directory_path() / fmt::format("foveola-{}", ::geteuid());
  constexpr mode_t own = 0700;
  ::mkdir(folder.c_str(), own);
  struct stat status{};
  const bool is_own = ::lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) &&
                      status.st_uid == ::geteuid() && (status.st_mode & 0777) == own;
  if (!is_own) {
    throw Error(folder.string(), "is not a folder of yours alone", "set HOME, or remove it");
  }
  return folder;
}

/// Foveola's folder in the one named by the environment variable, else in `usual` of the user's
/// home. Relative paths are ignored, as the XDG Base Directory Specification requires.
fs::path user_folder(const char* variable, const fs::path& usual) {
  if (const fs::path chosen = path_from_environment(variable); chosen.is_absolute()) {
    return chosen / "foveola";
  }
  if (const fs::path home = path_from_environment("HOME"); !home.empty()) {
    return home / usual / "foveola";
  }
  return own_temporary_folder();
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The final target of a symbolic link, existing or not.
fs::path followed(fs::path path) {
  constexpr int max_links = 40;  // Linux's limit
  std::error_code failure;
  for (int i = 0; i < max_links && fs::is_symlink(path, failure); ++i) {
    path = path.parent_path() / fs::read_symlink(path, failure);
  }
  return path;
}

Error cannot_be_read(const fs::path& path) {
  return {path.string(), "cannot be read", "check its permissions"};
}

/// Throws Error unless there is a regular file, and OutputIsInput. A pipe may never have a writer,
/// a device no end.
std::ifstream open_to_read(const fs::path& path) {
  require_no_output(path);
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (failure == std::errc::permission_denied) {
    throw Error(path.string(), "cannot be reached: " + failure.message(),
                "check the permissions of the folders above it");
  }
  if (!fs::exists(status)) {
    throw Error(path.string(), "no such file", "check the path");
  }
  if (fs::is_directory(status)) {
    throw Error(path.string(), "is a folder, not a file", "name a file in it");
  }
  if (!fs::is_regular_file(status)) {
    throw Error(path.string(), "is not a regular file", "copy its content into one");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw cannot_be_read(path);
  }
  return file;
}

/// A new file beside `path`, with its extension and an unpredictable name. Others cannot read a
/// replaced file's new content meanwhile.
fs::path make_temporary_beside(const fs::path& path, FileAccess access) {
  std::random_device random;  // of the operating system
  const fs::path temporary =
      folder_of(path) / fmt::format(".{}.{:08x}{:08x}.partial{}", path.stem().string(), random(),
                                    random(), path.extension().string());
  if (!make_new_file(temporary, fs::exists(path) ? FileAccess::own : access)) {
    throw Error(path.string(), "cannot be written: " + std::generic_category().message(errno),
                "choose another path");
  }
  return temporary;
}

}  // namespace

fs::path resource_folder() {
  if (fs::path chosen = path_from_environment("FOVEOLA_RESOURCES"); !chosen.empty()) {
    if (!fs::is_directory(chosen / "protocols")) {
      throw Error("FOVEOLA_RESOURCES=" + chosen.string(), "has no folder protocols/ in it",
                  "point it at Foveola's share folder or unset it");
    }
    return chosen;
  }
  if (const std::optional<fs::path> prefix = installation_prefix()) {
    return *prefix / FOVEOLA_RESOURCES_IN_PREFIX;
  }
  std::error_code ignored;
  if (fs::path source = FOVEOLA_SOURCE_FOLDER; fs::is_directory(source / "protocols", ignored)) {
    return source;
  }
  throw Error(own_program().string(), "cannot find its protocols, scenes and data",
              "set FOVEOLA_RESOURCES to the folder that holds them");
}

fs::path cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

fs::path data_folder() { return user_folder("XDG_DATA_HOME", fs::path(".local") / "share"); }

std::string read_file(const fs::path& path) {
  std::string content;
  read_file(path, content);
  return content;
}

void read_file(const fs::path& path, std::string& content) {
  constexpr std::size_t portion = 65536;
  std::ifstream file = open_to_read(path);
  std::error_code has_no_size;
  const std::uintmax_t stated = fs::file_size(path, has_no_size);
  std::size_t size = 0;
  // All at once; then any bytes beyond the size, as of a growing file.
  for (std::size_t wanted = has_no_size ? portion : stated + 1; file; wanted = portion) {
    content.resize(size + wanted);
    file.read(content.data() + size, static_cast<std::streamsize>(wanted));
    size += static_cast<std::size_t>(file.gcount());
  }
  if (!file.eof()) {
    throw cannot_be_read(path);
  }
  content.resize(size);
}

std::string read_file(const fs::path& path, std::size_t max_bytes, const std::string& remedy) {
  constexpr std::size_t portion = 65536;
  std::ifstream file = open_to_read(path);
  std::string content;
  std::size_t size = 0;
  while (file && size <= max_bytes) {
    content.resize(size + portion);
    file.read(content.data() + size, portion);
    size += static_cast<std::size_t>(file.gcount());
  }
  if (size > max_bytes) {
    throw Error(path.string(),
                fmt::format("has over {} bytes, the maximum that is read", max_bytes), remedy);
  }
  if (!file.eof()) {
    throw cannot_be_read(path);
  }
  content.resize(size);
  return content;
}

std::string lower_case_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return extension;
}

void require_writable(const fs::path& path) {
  const fs::path folder = folder_of(followed(path));
  std::error_code failure;
  const fs::file_status status = fs::status(folder, failure);
  if (failure == std::errc::permission_denied) {
    throw Error(path.string(), "the folder " + folder.string() + " cannot be reached",
                "check the permissions of the folders above it");
  }
  if (fs::exists(status) && !fs::is_directory(status)) {
    throw Error(path.string(), folder.string() + " is a file, not a folder", "choose another path");
  }
  if (!fs::exists(status)) {
    throw Error(path.string(), "the folder " + folder.string() + " does not exist",
                "create it or choose another path");
  }
  if (fs::is_directory(path, failure)) {
    throw Error(path.string(), "is a folder, not a file", "name a file in it");
  }
  if (fs::is_other(path, failure)) {
    throw Error(path.string(), "is not a regular file", "choose another path");
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    throw Error(path.string(), "the folder " + folder.string() + " cannot be written",
                "check its permissions or choose another path");
  }
}

void sync_to_disk(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int fault = errno;
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  if (!synced) {
    throw Error(path.string(), "cannot be made: " + std::generic_category().message(fault),
                "choose another path");
  }
}

TemporaryFile::TemporaryFile(fs::path final_path, FileAccess access)
    : final_path_(followed(std::move(final_path))) {
  require_writable(final_path_);
  path_ = make_temporary_beside(final_path_, access);
}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void TemporaryFile::replace_final() const {
  take_access(path_, final_path_);
  sync_to_disk(path_);
  std::error_code failure;
  fs::rename(path_, final_path_, failure);
  if (failure) {
    throw Error(final_path_.string(), "cannot be written: " + failure.message(),
                "choose another path");
  }
  sync_to_disk(folder_of(final_path_));
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write,
                  FileAccess access) {
  const TemporaryFile temporary(path, access);
  write(temporary.path());
  temporary.replace_final();
}

void write_file(const fs::path& path, std::string_view content, FileAccess access) {
  const auto write = [&](const fs::path& temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      throw Error(path.string(), "cannot be written", "check its permissions and the free space");
    }
  };
  replace_file(path, write, access);
}

ScratchFolder::ScratchFolder() {
  std::string name = (fs::temp_directory_path() / "foveola-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw Error(name, "no temporary folder can be made", "set TMPDIR to a folder with space");
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace foveola
