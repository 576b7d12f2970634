// Who may read and write a file: of new ones that hold what a person did, its user alone; of one
// whose content is replaced, whoever could before.
#pragma once

#include <filesystem>

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

}  // namespace foveola
