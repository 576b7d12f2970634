// Reports changes of files: written in place, renamed into place, removed, or replaced by another
// folder or link on their path.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <stop_token>
#include <string>

#include "renderer/base/clock.h"

namespace foveola {

/// Quiet times after which a change counts as complete.
struct FileWatchTiming {
  /// After a file was closed or renamed into place: related files may follow.
  Nanoseconds quiet_after_whole_file = std::chrono::milliseconds(20);
  /// After a write to a file that its writer keeps open.
  Nanoseconds quiet_while_open = std::chrono::milliseconds(500);
};

enum class FileChange {
  none,
  of_another_file,  ///< in the folder of a watched file
  of_watched_file   ///< and perhaps of others
};

/// Watches every folder and link on the files' paths through the kernel (inotify(7)). A kernel
/// watch stays with a folder and not with its name, so any folder may be replaced or be missing for
/// a while. Needs no thread: changes are queued until wait_for_change.
class FileWatch {
 public:
  /// Throws Error if the system does not allow more watched folders.
  explicit FileWatch(FileWatchTiming timing = {});
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches the files with these names from now on, existing or not, and no others. Throws Error
  /// as above.
  void watch(const std::set<std::filesystem::path>& files);

  /// Waits for a change in the folders, until no file was written for the quiet time of `timing`.
  /// After a change of a watched file other files no longer count. A removed file has changed once
  /// it stays away for the quiet time of an open file. Returns none if `stop` is requested first.
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
  /// Watches the current targets of the names.
  void watch_again();
  /// Adds queued changes to `changes`, waiting for the first until `timeout`. False if none came.
  bool read_changes(Nanoseconds timeout, Changes& changes);

  FileWatchTiming timing_;
  SteadyClock clock_;
  int inotify_;
  std::set<std::filesystem::path> files_;
  std::map<int, Folder> folders_;  ///< by their descriptors
};

}  // namespace foveola
