// Recognises scene files of other programs, to tell users how to convert them.
#pragma once

#include <filesystem>

namespace foveola {

/// Throws Error that explains how to get a glTF file, if the first bytes or the extension show
/// another format: Blender's own, FBX, USD and others. Never refuses a glTF binary under any name,
/// nor an unreadable file.
void require_readable_format(const std::filesystem::path& file);

}  // namespace foveola
