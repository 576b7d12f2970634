// Meshes out of the parts of an OBJ file.
#pragma once

#include "renderer/scene/obj/file.h"
#include "renderer/scene/scene.h"
#include "renderer/scene/warnings.h"

namespace foveola {

/// The triangles of `part`, each vertex once, with texture coordinates only if `is_textured`;
/// material is left alone. Faces that lack a normal get that of their plane, where others have
/// some. Polygons become triangles; those without area or that are not finite are dropped with a
/// warning. Throws std::length_error as triangulate does.
Mesh mesh_of(const ObjFile& obj, const ObjPart& part, bool is_textured, Warnings& warnings);

}  // namespace foveola
