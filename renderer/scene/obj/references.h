// Finds the files named in OBJ files and material libraries, which may come from systems with
// backslashes and case-insensitive names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace foveola {

/// The file inside `folder` that `name` refers to, with surrounding blanks removed, as by
/// confined_file_if_there().
std::optional<std::filesystem::path> find_obj_reference(const std::filesystem::path& folder,
                                                        std::string_view name);

}  // namespace foveola
