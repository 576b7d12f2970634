// Finds the files that OBJ files and material libraries name: written on other systems, whose paths
// have backslashes and do not tell upper case from lower.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// The file inside `folder` that `name` refers to, as local_reference() has it, without blanks
/// around it. What no file is called exactly may be called in letters of another case (ASCII), if
/// only one file is. Nothing if there is none. Throws std::runtime_error that says why, as
/// confined_file does, if `name` leads out of the folder.
std::optional<std::filesystem::path> find_obj_reference(const std::filesystem::path& folder,
                                                        std::string_view name);

}  // namespace foveola
