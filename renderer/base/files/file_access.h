// Access to files. A new file with a person's data can be read by its user alone; a replaced file
// keeps its access. A file's references stay in its folder, and no output is an input.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/error.h"

namespace foveola {

enum class FileAccess {
  default_access,  ///< the umask's part of reading and writing for all
  own              ///< 0600; in a folder with the set-group-ID bit, which a group shares, 0660
};

/// Makes an empty file at `path`. Returns false if it cannot, also if a file or a link is there.
bool make_new_file(const std::filesystem::path& path, FileAccess access);

/// Gives a new file at `path` the mode, owner, group and access list of the file at `like`, if that
/// exists. Warns on standard error of each that could not be set.
void take_access(const std::filesystem::path& path, const std::filesystem::path& like);

/// The regular file that `relative` names inside `folder` or a folder of it, as an absolute path
/// without symbolic links. Throws std::runtime_error that names the fault ("an absolute path"): an
/// empty name, a path through "..", a symbolic link out of the folder, or a missing or irregular
/// file.
std::filesystem::path confined_path(const std::filesystem::path& folder,
                                    const std::filesystem::path& relative);

class OutputIsInput : public Error {
 public:
  using Error::Error;
};

/// Makes require_no_output() refuse the existing file at `path` under any of its names. option: the
/// option that names it, "--output". To be called before other threads start.
void guard_output(const std::string& option, const std::filesystem::path& path);

/// Throws OutputIsInput if `input` is a guarded file. Called wherever a command opens an input. A
/// file that the command has since written in its place may be read.
void require_no_output(const std::filesystem::path& input);

}  // namespace foveola
