// The colours of an OBJ file's vertices, which tinyobjloader's reader line by line does not have.
#pragma once

#include <string_view>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// Linear colours of the vertices in the text of an OBJ file, in their order, white for those
/// without one; empty if none has one. They are written in sRGB, either as three numbers from 0 to
/// 1 after a vertex's coordinates (Blender since 3.2, MeshLab) or in comments "#MRGB" of eight
/// hexadecimal digits a vertex, whose first two are a mask (ZBrush; Blender reads both as sRGB
/// too).
std::vector<Rgb> vertex_colors_in(std::string_view text);

}  // namespace foveola
