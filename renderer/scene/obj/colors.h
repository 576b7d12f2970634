// Parses vertex colours of OBJ files, which tinyobjloader's line reader does not support.
#pragma once

#include <string_view>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola {

/// Linear colours of the vertices in the text of an OBJ file, in order, white for vertices without;
/// empty if none has one. The file's colours are sRGB: three numbers from 0 to 1 after a vertex's
/// coordinates (Blender since 3.2, MeshLab), or comments "#MRGB" of eight hexadecimal digits per
/// vertex, of which the first two are a mask (ZBrush; Blender reads both as sRGB too).
std::vector<Rgb> vertex_colors_in(std::string_view text);

}  // namespace foveola
