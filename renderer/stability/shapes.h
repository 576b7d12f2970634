// Small meshes and materials that the stress tests, and the tests of the tracer, build scenes from.
#pragma once

#include "renderer/scene/scene.h"

namespace foveola {

/// The parallelogram corner, corner + a, corner + a + b, corner + b; its front faces a x b. Its uvs
/// are the unit square.
Mesh quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material);

/// The same in cells x cells parallelograms of two triangles each, without uvs.
Mesh tessellated_quad(const Vec3& corner, const Vec3& a, const Vec3& b, int cells, int material);

/// The axis-aligned box of half side `half` around `center`, its fronts inside.
Mesh inward_box(const Vec3& center, float half, int material);

/// The same with cells x cells x 2 triangles a side. Neighbouring sides share the same vertices, so
/// that it stays watertight when it is moved.
Mesh tessellated_inward_box(const Vec3& center, float half, int cells, int material);

/// The closed tetrahedron around the origin whose corners are at a distance of `radius`, its fronts
/// inside: its edges are sharp (70.5 degrees), each side in cells^2 triangles.
Mesh inward_tetrahedron(float radius, int cells, int material);

/// A sphere of 20 * 4^level triangles around the origin, its fronts inside, smoothly shaded.
Mesh inward_sphere(float radius, int level, int material);

/// A ring about the Y axis, its fronts outside, smoothly shaded, in segments x segments cells.
Mesh torus(float ring_radius, float tube_radius, int segments, int material);

/// The same surface seen from its other side.
Mesh inside_out(Mesh mesh);
/// Without vertex normals: every triangle is flat.
Mesh flat_shaded(Mesh mesh);
/// Scaled, then turned, then moved.
Mesh placed(Mesh mesh, float scale, const Quat& turn, const Vec3& place);

/// Lambertian: nothing but diffuse reflection.
Material matte(const Rgb& albedo);
/// glTF's dielectric: diffuse under a specular coat.
Material dielectric(float albedo, float roughness = 1.0F);
Material metal(float albedo, float roughness);
/// Solid and colourless, with an index of refraction of 1.5.
Material glass(float roughness = 0.0F);
/// Shines and reflects nothing.
Material lamp(const Rgb& radiance, bool double_sided = false);

Environment constant_environment(float radiance);

}  // namespace foveola
