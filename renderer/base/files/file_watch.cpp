#include "renderer/base/files/file_watch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <list>
#include <system_error>
#include <utility>

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t whole_file = IN_CLOSE_WRITE | IN_MOVED_TO;
/// Events after which a name is another file's, or nobody's. Links, which are never closed, are
/// created whole.
constexpr std::uint32_t other_file = IN_CREATE | IN_MOVED_TO | IN_DELETE | IN_MOVED_FROM;

/// Maximum delay of a stop during a wait.
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
  files_ = files;
  std::map<int, Folder> before = std::exchange(folders_, {});
  for (const fs::path& file : files) {
    watch_steps(fs::absolute(file));
  }
  for (const auto& [descriptor, folder] : before) {
    if (!folders_.contains(descriptor)) {
      inotify_rm_watch(inotify_, descriptor);
    }
  }
}

void FileWatch::watch_steps(const fs::path& file) {
  int links_left = 40;  // the kernel's limit
  std::list<fs::path> names(file.begin(), file.end());
  fs::path place;  // without links
  for (; !names.empty(); names.pop_front()) {
    const fs::path& name = names.front();
    if (name.is_absolute() || name.empty() || name == ".") {
      place = name.is_absolute() ? name : place;
      continue;
    }
    if (name == "..") {
      place = place.parent_path();
      continue;
    }
    const bool is_last = std::next(names.begin()) == names.end();
    watch_name(place, name.string(), is_last);
    std::error_code is_no_link;
    const fs::path target = fs::read_symlink(place / name, is_no_link);
    if (is_no_link) {
      place /= name;
    } else if (links_left-- == 0) {
      return;
    } else {
      names.insert(std::next(names.begin()), target.begin(), target.end());
    }
  }
}

void FileWatch::watch_name(const fs::path& folder, const std::string& name, bool is_last) {
  const std::uint32_t events = IN_MASK_ADD | other_file | (is_last ? whole_file | IN_MODIFY : 0U);
  const int descriptor = inotify_add_watch(inotify_, folder.c_str(), events);
  if (descriptor >= 0) {
    Folder& watched = folders_[descriptor];
    watched.names.insert(name);
    watched.holds_files = watched.holds_files || is_last;
  } else if (errno != ENOENT && errno != ENOTDIR && errno != EACCES) {
    refuse("the folder " + folder.string() + " cannot be watched");
  }
}

void FileWatch::watch_again() {
  try {
    watch(std::set(files_));
  } catch (const Error&) {
    // Watches as much as possible; the next change may find more.
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
  bool has_other_files = false;
  const ssize_t size = read(inotify_, bytes.data(), bytes.size());
  for (ssize_t at = 0; at < size;) {
    const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
    at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
    const auto folder = folders_.find(event->wd);
    const bool is_watched = folder != folders_.end() && event->len > 0 &&
                            folder->second.names.contains(static_cast<const char*>(event->name));
    const bool is_lost = (event->mask & IN_Q_OVERFLOW) != 0;  // may have been of any file
    if (!is_watched && !is_lost && (folder == folders_.end() || !folder->second.holds_files)) {
      continue;
    }
    has_other_files |= is_lost || (is_watched && (event->mask & other_file) != 0);
    const FileChange which =
        is_watched || is_lost ? FileChange::of_watched_file : FileChange::of_another_file;
    if (which >= changes.which) {
      changes = {.which = which, .is_last_whole = (event->mask & whole_file) != 0};
      has_any = true;
    }
  }
  if (has_other_files) {
    watch_again();
  }
  return has_any;
}

}  // namespace foveola
