// Scene files of other programs, which are told apart so that users learn what to do with them.
#pragma once

#include <filesystem>
#include <string>

namespace foveola {

/// The file name's extension with its dot, in lower case, by which scene files are told apart.
std::string lower_case_extension(const std::filesystem::path& file);

/// Throws Error, with the way to a glTF file, for a file that is known by its first bytes or by its
/// extension to be in another format: Blender's own, FBX, USD and others. A glTF binary is never
/// refused, whatever it is called, nor is a file that cannot be read.
void require_readable_format(const std::filesystem::path& file);

}  // namespace foveola
