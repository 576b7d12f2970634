#include "renderer/base/file_watch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <system_error>

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t whole_file = IN_CLOSE_WRITE | IN_MOVED_TO;
/// Links to a file, which nobody closes, are created whole.
constexpr std::uint32_t part_of_file = IN_MODIFY | IN_CREATE;

/// How long a wait may keep a stop waiting.
constexpr Nanoseconds longest_sleep = std::chrono::milliseconds(50);

[[noreturn]] void refuse(const std::string& what) {
  throw Error("watching files", what + ": " + std::strerror(errno),
              "end other programs that watch files, or raise fs.inotify.max_user_watches and "
              "max_user_instances");
}

bool is_readable_within(int descriptor, Nanoseconds timeout) {
  pollfd wanted{.fd = descriptor, .events = POLLIN, .revents = 0};
  const auto timeout_ms = std::chrono::ceil<std::chrono::milliseconds>(timeout).count();
  return poll(&wanted, 1, static_cast<int>(timeout_ms)) > 0;
}

}  // namespace

FileWatch::FileWatch(FileWatchTiming timing)
    : timing_(timing), inotify_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (inotify_ < 0) {
    refuse("the system refuses it");
  }
}

FileWatch::~FileWatch() { close(inotify_); }

void FileWatch::watch(const std::set<fs::path>& files) {
  names_.clear();
  for (const fs::path& file : files) {
    watch_folder(fs::absolute(file).lexically_normal());
    std::error_code is_missing;
    if (const fs::path real = fs::canonical(file, is_missing); !is_missing) {
      watch_folder(real);
    }
  }
  std::erase_if(folders_, [this](const auto& folder) {
    const bool is_idle = !names_.contains(folder.second);
    if (is_idle) {
      inotify_rm_watch(inotify_, folder.second);
    }
    return is_idle;
  });
}

void FileWatch::watch_folder(const fs::path& file) {
  const std::string folder = file.parent_path().string();
  const int descriptor = inotify_add_watch(inotify_, folder.c_str(), whole_file | part_of_file);
  if (descriptor >= 0) {
    folders_[folder] = descriptor;
    names_[descriptor].insert(file.filename().string());
  } else if (errno != ENOENT && errno != ENOTDIR && errno != EACCES) {
    refuse("the folder " + folder + " cannot be watched");
  }
}

FileChange FileWatch::wait_for_change(const std::stop_token& stop) {
  Changes changes;
  Nanoseconds last_change = clock_.now();
  while (!stop.stop_requested()) {
    const bool has_changed = changes.which != FileChange::none;
    const Nanoseconds quiet =
        changes.is_last_whole ? timing_.quiet_after_whole_file : timing_.quiet_while_open;
    const Nanoseconds left = last_change + quiet - clock_.now();
    if (has_changed && left <= Nanoseconds(0)) {
      return changes.which;
    }
    if (read_changes(has_changed ? std::min(left, longest_sleep) : longest_sleep, changes)) {
      last_change = clock_.now();
    }
  }
  return FileChange::none;
}

bool FileWatch::read_changes(Nanoseconds timeout, Changes& changes) {
  if (!is_readable_within(inotify_, timeout)) {
    return false;
  }
  alignas(inotify_event) std::array<char, 16384> bytes;
  bool has_any = false;
  const ssize_t size = read(inotify_, bytes.data(), bytes.size());
  for (ssize_t at = 0; at < size;) {
    const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
    at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    const auto folder = names_.find(event->wd);
    const bool is_watched = folder != names_.end() && event->len > 0 &&
                            folder->second.contains(static_cast<const char*>(event->name));
    const bool is_lost = (event->mask & IN_Q_OVERFLOW) != 0;  // it may have been any file's
    if (folder == names_.end() && !is_lost) {
      continue;
    }
    const FileChange which =
        is_watched || is_lost ? FileChange::of_watched_file : FileChange::of_another_file;
    if (which >= changes.which) {
      changes = {.which = which, .is_last_whole = (event->mask & whole_file) != 0};
      has_any = true;
    }
  }
  return has_any;
}

}  // namespace foveola
