// Finds the files named in OBJ files and material libraries, which may come from systems with
// backslashes and case-insensitive names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// The file inside `folder` that `name` refers to, as by local_reference(), with surrounding blanks
/// removed. Without an exact match, a unique match in another case (ASCII) counts. nullopt if there
/// is none. Throws std::runtime_error with the reason, as confined_file does, if `name` leads out
/// of the folder.
std::optional<std::filesystem::path> find_obj_reference(const std::filesystem::path& folder,
                                                        std::string_view name);

}  // namespace foveola
