#include "renderer/trace/surfaces/surface_points.h"

#include "renderer/trace/rays/mesh_attributes.h"

namespace foveola {
namespace {

struct CornerNormals {
  Vec3 p0, p1, p2;
};

/// The front's vertex normals of a triangle in the world, of any length; zero if the mesh has none.
CornerNormals corner_normals(const ObjectView& object, std::uint32_t triangle) {
  const Mesh& mesh = *object.mesh;
  if (mesh.normals.empty()) {
    return {Vec3(0.0F), Vec3(0.0F), Vec3(0.0F)};
  }
  const auto& [a, b, c] = mesh.triangles[triangle];
  if (object.instance == nullptr) {
    return {mesh.normals[a], mesh.normals[b], mesh.normals[c]};
  }
  const Mat3 turn = world_normal_from_local(object.instance->world_from_local);
  return {turn * mesh.normals[a], turn * mesh.normals[b], turn * mesh.normals[c]};
}

Vec3 at(const Vec3s& vectors, std::size_t lane) {
  return {vectors.x[lane], vectors.y[lane], vectors.z[lane]};
}

}  // namespace

void SurfaceHits::put(std::size_t lane, const ObjectView& object, std::uint32_t index) {
  filled_ |= 1U << lane;
  if (object.instance != nullptr && !has_instances_) {
    expect_instances();
  }
  normals_.put(lane, corner_normals(object, index));
  if (!has_instances_) {
    const auto& [a, b, c] = object.mesh->triangles[index];
    corners_.p0.put(lane, object.mesh->positions[a]);
    corners_.p1.put(lane, object.mesh->positions[b]);
    corners_.p2.put(lane, object.mesh->positions[c]);
    return;
  }
  const Triangle triangle(*object.mesh, object.instance, index);
  corners_.put(lane, triangle);
  largest_term_[lane] = triangle.largest_term;
  roundings_[lane] = triangle.roundings;
  winding_[lane] = triangle.winding;
}

void SurfaceHits::expect_instances() {
  has_instances_ = true;
  largest_term_.store(
      largest_coordinate(corners_.p0.load(), corners_.p1.load(), corners_.p2.load()));
  roundings_.fill(Triangle::default_roundings);
  winding_.fill(1.0F);
}

TriangleOf<Floats> SurfaceHits::triangles() const {
  const Vec3s p0 = corners_.p0.load();
  const Vec3s p1 = corners_.p1.load();
  const Vec3s p2 = corners_.p2.load();
  if (has_instances_) {
    return {p0, p1, p2, largest_term_.load(), roundings_.load(), winding_.load()};
  }
  return {p0,
          p1,
          p2,
          largest_coordinate(p0, p1, p2),
          all_lanes(Triangle::default_roundings),
          all_lanes(1.0F)};
}

Vec3s SurfaceHits::front_normal(const TriangleOf<Floats>::Front& front) const {
  const std::uint32_t inexact = bits_of(~front.is_exact) & filled_;
  if (inexact == 0) {
    return front.normal;
  }
  Vec3Lanes normals;
  normals.store(front.normal);
  for_each_lane(inexact, [&](std::size_t lane) {
    normals.put(
        lane, front_normal_in_double(corners_.p0.at(lane), corners_.p1.at(lane),
                                     corners_.p2.at(lane), has_instances_ ? winding_[lane] : 1.0F));
  });
  return normals.load();
}

void SurfacePoints::turn_shading_normal(std::size_t lane, const Vec3s& direction,
                                        const Vec3& mapped) {
  const Vec3 turned = SurfaceGeometryOf<float>::turned_to_ray(
      at(smooth_normal, lane), at(geometric_normal, lane), mapped, at(direction, lane),
      at(shading_normal, lane));
  shading_normal.x[lane] = turned.x;
  shading_normal.y[lane] = turned.y;
  shading_normal.z[lane] = turned.z;
}

SurfacePoints SurfaceHits::points(const Vec3s& direction, const Vec2s& barycentric,
                                  const Floats& distance) const {
  const TriangleOf<Floats> triangle = triangles();
  const TriangleOf<Floats>::Front front = triangle.front();
  const Vec3s vertex_normal =
      interpolate(normals_.p0.load(), normals_.p1.load(), normals_.p2.load(), barycentric);
  return {SurfaceGeometryOf<Floats>(triangle, front_normal(front), vertex_normal, barycentric,
                                    direction, distance),
          front.double_area};
}

}  // namespace foveola
