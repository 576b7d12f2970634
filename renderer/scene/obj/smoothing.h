// Smooth normals of an OBJ file's smoothing groups ("s 1").
#pragma once

#include <string_view>
#include <vector>

#include "renderer/scene/obj/file.h"

namespace foveola {

/// The smoothing group of each "f" statement of `text`, in their order, 0: none; empty if no face
/// has one.
std::vector<unsigned> smoothing_groups_in(std::string_view text);

/// Gives the faces of a smoothing group that have no normals of their own, at each vertex, the mean
/// of the group's faces there, weighted by their areas.
void add_smooth_normals(ObjFile& obj);

}  // namespace foveola
