// Keeps the files that a file names inside its own folder.
#pragma once

#include <filesystem>

namespace foveola {

/// The regular file that `relative` names inside `folder` or a folder of it, as an absolute path
/// without symbolic links. Throws std::runtime_error that says what it is instead ("an absolute
/// path"): no name, a path through "..", a symbolic link that leads out of the folder, a file that
/// does not exist, or not a regular one.
std::filesystem::path confined_path(const std::filesystem::path& folder,
                                    const std::filesystem::path& relative);

}  // namespace foveola
