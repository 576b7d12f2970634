// Scene files of other programs, which are told apart so that users learn what to do with them.
#pragma once

#include <filesystem>

namespace foveola {

/// Throws Error, with the way to a glTF file, for a file that is known by its first bytes or by its
/// extension to be in another format: Blender's own, FBX, USD and others. A glTF binary is never
/// refused, whatever it is called, nor is a file that cannot be read.
void require_readable_format(const std::filesystem::path& file);

}  // namespace foveola
