// Tells when files change, however that is done: written in place, renamed into their place,
// removed, or by another folder or link on the way to them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>

#include "renderer/base/clock.h"

namespace foveola {

/// When a change counts as done.
struct FileWatchTiming {
  /// After a file was closed or renamed into place: others may follow that belong to it.
  Nanoseconds quiet_after_whole_file = std::chrono::milliseconds(20);
  /// After a file was written to that its writer keeps open.
  Nanoseconds quiet_while_open = std::chrono::milliseconds(500);
};

enum class FileChange {
  none,
  of_another_file,  ///< in the folder of one that is watched
  of_watched_file   ///< and perhaps of others
};

/// Watches every folder and link on the way to files through the kernel (inotify(7)), whose watches
/// stay with a folder and not with its name, so that any of them may be replaced, or be missing for
/// a while. It needs no thread of its own: changes that come before anybody waits
/// for them are kept.
class FileWatch {
 public:
  /// Throws Error if the system does not let more folders be watched.
  explicit FileWatch(FileWatchTiming timing = {});
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches what has these names from now on and no others, whether it is there or not. Throws
  /// Error as above.
  void watch(const std::set<std::filesystem::path>& files);

  /// Waits until a file in the folders has changed and none has been written to for as long as the
  /// timing says; once a watched file has changed, others count no more. A file that is gone has
  /// changed, once it stays away as long as one that is kept open. None if `stop` was requested
  /// before.
  FileChange wait_for_change(const std::stop_token& stop);

 private:
  /// Changes that came together.
  struct Changes {
    FileChange which = FileChange::none;
    bool is_last_whole = false;  ///< whether the last file to change is complete
  };

  struct Folder {
    std::set<std::string> names;  ///< files, and folders and links on the way to them
    bool holds_files = false;     ///< not only folders and links
  };

  /// Watches each name on the way to the file, which is absolute.
  void watch_steps(const std::filesystem::path& file);
  void watch_name(const std::filesystem::path& folder, const std::string& name, bool is_last);
  /// Watches what has the names now.
  void watch_again();
  /// Adds those that came to `changes`, waiting for the first until `timeout`. False if none came.
  bool read_changes(Nanoseconds timeout, Changes& changes);

  FileWatchTiming timing_;
  SteadyClock clock_;
  int inotify_;
  std::set<std::filesystem::path> files_;
  std::map<int, Folder> folders_;  ///< by their descriptors
};

}  // namespace foveola
