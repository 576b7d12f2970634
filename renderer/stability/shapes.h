// Small meshes and materials for the scenes of the stress tests and of the tracer's tests.
#pragma once

#include "renderer/scene/scene.h"

namespace foveola {

/// The parallelogram corner, corner + a, corner + a + b, corner + b, with front normal a x b. Its
/// uvs are the unit square.
Mesh quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material);

/// The same in cells x cells parallelograms of two triangles each, without uvs.
Mesh tessellated_quad(const Vec3& corner, const Vec3& a, const Vec3& b, int cells, int material);

/// The axis-aligned box of half side `half` around `center`, with front faces inside.
Mesh inward_box(const Vec3& center, float half, int material);

/// The same with cells x cells x 2 triangles per side. Adjacent sides share vertices, so that it
/// stays watertight when it is moved.
Mesh tessellated_inward_box(const Vec3& center, float half, int cells, int material);

/// The closed tetrahedron around the origin with corners at distance `radius`, sharp edges (70.5
/// degrees), cells^2 triangles per side, and front faces inside.
Mesh inward_tetrahedron(float radius, int cells, int material);

/// A smoothly shaded sphere of 20 * 4^level triangles around the origin, with front faces inside.
Mesh inward_sphere(float radius, int level, int material);

/// A smoothly shaded torus about the Y axis in segments x segments cells, with front faces outside.
Mesh torus(float ring_radius, float tube_radius, int segments, int material);

/// The same surface with front and back faces exchanged.
Mesh inside_out(Mesh mesh);
/// Without vertex normals: every triangle is flat.
Mesh flat_shaded(Mesh mesh);
/// Scaled, then rotated, then moved.
Mesh placed(Mesh mesh, float scale, const Quat& turn, const Vec3& place);

/// Lambertian: diffuse reflection only.
Material matte(const Rgb& albedo);
/// glTF's dielectric: diffuse under a specular coat.
Material dielectric(float albedo, float roughness = 1.0F);
Material metal(float albedo, float roughness);
/// Solid and colourless, with an index of refraction of 1.5.
Material glass(float roughness = 0.0F);
/// Emits and reflects nothing.
Material lamp(const Rgb& radiance, bool double_sided = false);

Environment constant_environment(float radiance);

}  // namespace foveola
