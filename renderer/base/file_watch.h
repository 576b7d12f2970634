// Tells when files change, however that is done: written in place, or renamed into their place.
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

/// Watches the folders of files through the kernel (inotify(7)), so that files may be replaced, or
/// be missing for a while. It needs no thread of its own: changes that come before anybody waits
/// for them are kept.
class FileWatch {
 public:
  /// Throws Error if the system does not let more folders be watched.
  explicit FileWatch(FileWatchTiming timing = {});
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// Watches these files from now on and no others. A link's own folder is watched as well as that
  /// of the file that it leads to. Folders that are not there are left out. Throws Error as above.
  void watch(const std::set<std::filesystem::path>& files);

  /// Waits until a file in the folders has changed and none has been written to for as long as the
  /// timing says; once a watched file has changed, others count no more. None if `stop` was
  /// requested before.
  FileChange wait_for_change(const std::stop_token& stop);

 private:
  /// Changes that came together.
  struct Changes {
    FileChange which = FileChange::none;
    bool is_last_whole = false;  ///< whether the last file to change is complete
  };

  void watch_folder(const std::filesystem::path& file);
  /// Adds those that came to `changes`, waiting for the first until `timeout`. False if none came.
  bool read_changes(Nanoseconds timeout, Changes& changes);

  FileWatchTiming timing_;
  SteadyClock clock_;
  int inotify_;
  std::map<std::string, int> folders_;          ///< descriptors of watched folders, by their path
  std::map<int, std::set<std::string>> names_;  ///< of the files in each folder, by its descriptor
};

}  // namespace foveola
