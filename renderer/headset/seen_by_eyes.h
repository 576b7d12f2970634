// Which part of the view that holds both eyes' is ever seen by either.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <openxr/openxr.h>

#include "renderer/view/viewport.h"

namespace foveola {

/// What a lens never shows: the corners of triangles, three for each, on the plane at distance 1
/// before its eye, x to the right and y up.
using HiddenTriangles = std::vector<Vec2>;

/// Of 64 by 64 cells those in which, or at whose edges, an eye sees anything. Null if that is all
/// of them, or none. both: field_of_view_of_both. head: in the same space as the eyes.
std::shared_ptr<const SeenPart> seen_by_eyes(const std::array<XrView, 2>& eyes, const Quat& head,
                                             const FieldOfView& both,
                                             const std::array<HiddenTriangles, 2>& hidden);

}  // namespace foveola
