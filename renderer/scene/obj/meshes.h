// Converts the parts of an OBJ file to meshes.
#pragma once

#include "renderer/scene/obj/file.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The triangles of `part` with shared vertices, and with texture coordinates only if
/// `is_textured`; material is not set. If some faces have normals, the others get that of their
/// plane. Polygons are triangulated; triangles without area or with non-finite corners are dropped
/// with a warning. Throws std::length_error as triangulate does.
Mesh mesh_of(const ObjFile& obj, const ObjPart& part, bool is_textured, Warnings& warnings);

}  // namespace foveola
