// Which files may be read and written. Who may read and write a new file: of those that hold what a
// person did, its user alone; of one whose content is replaced, whoever could before. No file that
// a file names leaves its folder, and no output is an input.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/error.h"

namespace foveola {

enum class FileAccess {
  usual,  ///< what the umask leaves of reading and writing for all
  own     ///< 0600; in a folder with the set-group-ID bit, which a group shares, 0660
};

/// Makes an empty file at `path`, where there must be none, not even a link. Returns whether it
/// could be made.
bool make_new_file(const std::filesystem::path& path, FileAccess access);

/// Gives a new file at `path` the mode, owner, group and access list of the one at `like`, if there
/// is one, and warns on standard error of what could not be given.
void take_access(const std::filesystem::path& path, const std::filesystem::path& like);

/// The regular file that `relative` names inside `folder` or a folder of it, as an absolute path
/// without symbolic links. Throws std::runtime_error that says what it is instead ("an absolute
/// path"): no name, a path through "..", a symbolic link that leads out of the folder, a file that
/// does not exist, or not a regular one.
std::filesystem::path confined_path(const std::filesystem::path& folder,
                                    const std::filesystem::path& relative);

class OutputIsInput : public Error {
 public:
  using Error::Error;
};

/// From now on the file that `path` names, if it is there, is refused by require_no_output(),
/// whatever other name it has. option: the one that names it, "--output". To be called before there
/// are other threads.
void guard_output(const std::string& option, const std::filesystem::path& path);

/// To be called where a command opens an input. Throws OutputIsInput for a guarded file. A file
/// that has taken its place since, which the command wrote, may be read.
void require_no_output(const std::filesystem::path& input);

}  // namespace foveola
