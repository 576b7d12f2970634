// The shapes that built-in scenes are put together from.
//
// They are built in double precision and rounded once, when a model takes them, so that the last
// bits in which machines' sine and cosine differ do not reach the file.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola::scenes {

using DVec2 = glm::dvec2;

/// Triangles without normals; counter-clockwise seen from outside. Lengths in metres; unless a
/// function says otherwise, uvs are lengths in metres too, so that patterns keep their size.
struct Shape {
  std::vector<DVec3> positions;
  std::vector<DVec2> uvs;  ///< one a position
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

void append(Shape& to, const Shape& from);

/// `transform` applied to the positions; a mirroring one turns the triangles too, so that outside
/// stays outside.
Shape transformed(Shape shape, const DMat4& transform);
Shape moved(Shape shape, const DVec3& offset);
/// Turned about the Y axis, +Z towards +X for a positive angle.
Shape turned(Shape shape, double angle_deg);
/// Turned about any axis by the right-hand rule.
Shape turned(Shape shape, double angle_deg, const DVec3& axis);
Shape scaled(Shape shape, const DVec3& factors);
/// uvs multiplied by `factor`.
Shape with_uv_scale(Shape shape, double factor);
/// uvs by projection: lengths along two directions.
Shape with_projected_uvs(Shape shape, const DVec3& u_direction, const DVec3& v_direction);
/// `position` applied to each position; it must not mirror.
Shape deformed(Shape shape, const std::function<DVec3(const DVec3&)>& position);
/// The same surface seen from its other side.
Shape inside_out(Shape shape);

/// The parallelogram at `corner`, seen from the side of cross(edge_u, edge_v).
Shape rectangle(const DVec3& corner, const DVec3& edge_u, const DVec3& edge_v);

/// The same with uvs over [0, 1]: u along edge_u, v against edge_v, so that an image stands upright
/// where edge_v points up.
Shape picture(const DVec3& corner, const DVec3& edge_u, const DVec3& edge_v);

/// The box between two opposite corners.
Shape box(const DVec3& lower, const DVec3& upper);
/// A box of `size` whose middle is the origin.
Shape box(const DVec3& size);
/// The same with edges rounded to `radius` in `steps` steps; radius is at most half the least size.
/// The flat middle of each face has `cells` by `cells` cells, for bending.
Shape rounded_box(const DVec3& size, double radius, int steps, int cells = 1);

using SurfaceFunction = std::function<DVec3(double u, double v)>;

/// position(u, v) over the unit square in columns * rows cells, seen from the side of
/// cross(dp/du, dp/dv); uvs are (u, v).
Shape patch(int columns, int rows, const SurfaceFunction& position);

/// The outline of radii (x) and heights (y) turned about the Y axis. Outlines that run upwards on
/// the outside face outwards. uvs: turn in [0, 1], length along the outline.
Shape lathe(const std::vector<DVec2>& outline, int segments);

/// A closed cylinder or cone standing on the origin.
Shape cylinder(double radius, double height, int segments);
Shape cone(double bottom_radius, double top_radius, double height, int segments);
Shape ellipsoid(const DVec3& radii, int segments);
/// A ring about the Y axis whose tube's middle is a circle of `ring_radius`.
Shape torus(double ring_radius, double tube_radius, int ring_segments, int tube_segments);

/// A round tube with closed ends along a line of two or more points.
Shape tube(const std::vector<DVec3>& path, double radius, int segments);

/// One bay of an arcade: the wall above a round-headed opening, its faces at z = +-thickness / 2
/// and its soffit; neighbouring bays hide its ends and what stands on it its top. The opening's
/// middle is x = 0 and its jambs start at y = 0.
struct ArchBay {
  double bay_width = 3.0;
  double opening_width = 2.4;
  double springing_height = 0.0;  ///< where the semicircle begins; below it the jambs are straight
  double height = 2.0;            ///< height of the wall's top
  double thickness = 0.4;
};
Shape arch(const ArchBay& bay, int segments);

}  // namespace foveola::scenes
