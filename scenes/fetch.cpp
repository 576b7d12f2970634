#include "scenes/fetch.h"

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/print.h"
#include "renderer/base/text/utf8.h"
#include "scenes/descriptor_search.h"
#include "scenes/download.h"
#include "scenes/file_search.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

/// Returns the file's place, after making its folder.
fs::path prepare_target(const Descriptor& descriptor) {
  const fs::path folder =
      is_programs_own(descriptor) ? fetched_folder() : fs::absolute(descriptor.path).parent_path();
  const fs::path target = folder / descriptor.file_name;
  std::error_code failure;
  fs::create_directories(target.parent_path(), failure);
  if (failure) {
    throw Error(target.parent_path().string(), "cannot be made: " + failure.message(),
                "set XDG_DATA_HOME to another folder");
  }
  require_writable(target);
  return target;
}

bool is_there(const Descriptor& descriptor, const fs::path& target) {
  std::error_code ignored;
  return fs::is_regular_file(target, ignored) && is_described_file(descriptor, target);
}

/// A partial download, locked by one program at a time. During the lock its name may become the
/// scene's file, or be removed, and nothing else.
class LockedPart {
 public:
  /// Makes the file if it is missing. Waits while another program has it. Throws Error if it cannot
  /// be opened or `stop` is requested.
  LockedPart(fs::path path, const std::stop_token& stop) : path_(std::move(path)) {
    constexpr std::chrono::milliseconds pause(100);
    bool is_told = false;
    while (!try_to_lock()) {
      if (stop.stop_requested()) {
        throw Error(path_.string(), "another program is downloading it", "wait until it ends");
      }
      if (!std::exchange(is_told, true)) {
        print_text(stderr, "Another program is downloading {}; waiting for it.\n",
                   printable(path_.stem().string()));
      }
      std::this_thread::sleep_for(pause);
    }
  }
  LockedPart(const LockedPart&) = delete;
  LockedPart& operator=(const LockedPart&) = delete;
  ~LockedPart() {
    std::error_code ignored;
    if (is_named() && fs::file_size(path_, ignored) == 0 && !ignored) {
      fs::remove(path_, ignored);
    }
    ::close(descriptor_);
  }

  const fs::path& path() const { return path_; }

 private:
  bool try_to_lock() {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      throw Error(path_.string(), "cannot be written: " + std::generic_category().message(errno),
                  "check the folder's permissions and the free space");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && is_named()) {
      return true;
    }
    ::close(descriptor_);
    return false;
  }

  bool is_named() const {
    struct stat open{};
    struct stat named{};
    return ::fstat(descriptor_, &open) == 0 && ::stat(path_.c_str(), &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
  }

  fs::path path_;
  int descriptor_ = -1;
};

/// Returns the file of --from. Throws Error if there is none.
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

/// Returns whether `content` is a complete .glb, as long as its header says.
bool is_whole_glb(std::string_view content) {
  constexpr std::size_t header_bytes = 12;
  constexpr std::size_t length_offset = 8;
  if (content.size() < header_bytes || !content.starts_with("glTF")) {
    return false;
  }
  std::uint32_t announced_bytes = 0;
  std::memcpy(&announced_bytes, content.data() + length_offset, sizeof announced_bytes);
  return announced_bytes == content.size();
}

void require_accepted(const Descriptor& descriptor, const fs::path& file,
                      const std::string& content, Accept accept) {
  if (accept == Accept::any_glb) {
    if (!is_whole_glb(content)) {
      throw Error(file.string(), "is not a glTF binary, or is truncated", "export it as .glb");
    }
  } else if (!descriptor.sha256.empty() && sha256(std::string_view(content)) != descriptor.sha256) {
    throw Error(file.string(),
                fmt::format("is not the {} that the descriptor means: its SHA-256 differs",
                            descriptor.file_name),
                "to use a conversion of your own in its place, add --unverified");
  }
}

}  // namespace

fs::path fetch_from_web(const Descriptor& descriptor, const std::function<void(double)>& progress,
                        const std::stop_token& stop) {
  if (descriptor.address.empty()) {
    throw Error(descriptor.name, "its file has no download address",
                fmt::format("get the scene from {}, convert it to .glb and add --from "
                            "FILE.glb --unverified",
                            descriptor.origin));
  }
  const fs::path target = prepare_target(descriptor);
  if (is_there(descriptor, target)) {
    return target;
  }
  const LockedPart part(target.string() + ".part", stop);
  if (is_there(descriptor, target)) {
    return target;  // written by the program that had the part
  }
  download(descriptor.address, part.path(), descriptor.size_bytes, progress, stop);
  if (sha256_of_file(part.path()) != descriptor.sha256) {
    fs::remove(part.path());
    throw Error(descriptor.address,
                "is not the file that the descriptor means: its SHA-256 differs",
                "it was changed or damaged on its way; try again, or download it by hand");
  }
  fs::rename(part.path(), target);
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
