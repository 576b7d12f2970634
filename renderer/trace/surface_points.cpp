#include "renderer/trace/surface_points.h"

#include "renderer/trace/surface.h"
#include "renderer/trace/triangle.h"

namespace foveola {
namespace {

Vec3s normalized_or(const Vec3s& normal, const Vec3s& otherwise) {
  const Floats squared_length = dot(normal, normal);
  return chosen(squared_length > 0.0F, (1.0F / square_root(squared_length)) * normal, otherwise);
}

Vec3 at(const Vec3s& vectors, std::size_t lane) {
  return {vectors.x[lane], vectors.y[lane], vectors.z[lane]};
}

Floats largest_coordinate(const Vec3s& p0, const Vec3s& p1, const Vec3s& p2) {
  return max_component(larger(magnitude(p0), larger(magnitude(p1), magnitude(p2))));
}

}  // namespace

void SurfaceHits::put(std::size_t lane, const ObjectView& object, const Hit& hit) {
  filled_ |= 1U << lane;
  u_[lane] = hit.barycentric.x;
  v_[lane] = hit.barycentric.y;
  distance_[lane] = hit.t;
  if (object.instance != nullptr) {
    put_instance(lane, object, hit);
    return;
  }
  const Mesh& mesh = *object.mesh;
  const auto& triangle = mesh.triangles[hit.triangle];
  corners_.p0.put(lane, mesh.positions[triangle[0]]);
  corners_.p1.put(lane, mesh.positions[triangle[1]]);
  corners_.p2.put(lane, mesh.positions[triangle[2]]);
  if (!mesh.normals.empty()) {
    normals_.p0.put(lane, mesh.normals[triangle[0]]);
    normals_.p1.put(lane, mesh.normals[triangle[1]]);
    normals_.p2.put(lane, mesh.normals[triangle[2]]);
  } else {
    normals_.p0.put(lane, Vec3(0.0F));
    normals_.p1.put(lane, Vec3(0.0F));
    normals_.p2.put(lane, Vec3(0.0F));
  }
  if (has_instances_) {
    const Triangle corners(mesh, hit.triangle);
    largest_term_[lane] = corners.largest_term;
    roundings_[lane] = corners.roundings;
    winding_[lane] = corners.winding;
  }
}

void SurfaceHits::put_instance(std::size_t lane, const ObjectView& object, const Hit& hit) {
  if (!has_instances_) {
    has_instances_ = true;
    largest_term_.store(
        largest_coordinate(corners_.p0.load(), corners_.p1.load(), corners_.p2.load()));
    roundings_.fill(Triangle::usual_roundings);
    winding_.fill(1.0F);
  }
  const Mesh& mesh = *object.mesh;
  const Triangle corners(mesh, object.instance, hit.triangle);
  corners_.p0.put(lane, corners.p0);
  corners_.p1.put(lane, corners.p1);
  corners_.p2.put(lane, corners.p2);
  largest_term_[lane] = corners.largest_term;
  roundings_[lane] = corners.roundings;
  winding_[lane] = corners.winding;
  Mat3 normals(0.0F);
  if (!mesh.normals.empty()) {
    const auto& triangle = mesh.triangles[hit.triangle];
    normals = world_normal_from_local(object.instance->world_from_local) *
              Mat3(mesh.normals[triangle[0]], mesh.normals[triangle[1]], mesh.normals[triangle[2]]);
  }
  normals_.p0.put(lane, normals[0]);
  normals_.p1.put(lane, normals[1]);
  normals_.p2.put(lane, normals[2]);
}

Vec3s SurfaceHits::front_normal(const Vec3s& side1, const Vec3s& side2, Floats& double_area) const {
  const Vec3s across = cross(side1, side2);
  const Floats squared = dot(across, across);
  double_area = square_root(squared);
  Floats scale = 1.0F / double_area;
  if (has_instances_) {
    scale *= winding_.load();
  }
  Vec3s normal = scale * across;
  const LaneMask is_usual =
      (squared > Triangle::smallest_square) & (squared < Triangle::largest_square);
  const std::uint32_t unusual = bits_of(~is_usual) & filled_;
  if (unusual == 0) {
    return normal;
  }
  Vec3Lanes normals;
  normals.store(normal);
  for_each_lane(unusual, [&](std::size_t lane) {
    normals.put(
        lane, front_normal_in_double(corners_.p0.at(lane), corners_.p1.at(lane),
                                     corners_.p2.at(lane), has_instances_ ? winding_[lane] : 1.0F));
  });
  return normals.load();
}

void SurfacePoints::turn_shading_normal(std::size_t lane, const Vec3s& direction,
                                        const Vec3& mapped) {
  const float side = glm::dot(at(smooth_normal, lane), at(geometric_normal, lane));
  const Vec3 shading = std::copysign(1.0F, side) * mapped;
  if (glm::dot(shading, at(direction, lane)) < 0.0F) {
    shading_normal.x[lane] = shading.x;
    shading_normal.y[lane] = shading.y;
    shading_normal.z[lane] = shading.z;
  }
}

SurfacePoints SurfaceHits::points(const Vec3s& direction) const {
  const Vec3s p0 = corners_.p0.load();
  const Vec3s p1 = corners_.p1.load();
  const Vec3s p2 = corners_.p2.load();
  const Vec3s side1 = p1 - p0;
  const Vec3s side2 = p2 - p0;
  const Floats u = u_.load();
  const Floats v = v_.load();
  SurfacePoints points;
  const Vec3s front = front_normal(side1, side2, points.double_area);
  points.facing = -dot(front, direction);
  points.geometric_normal = chosen(points.facing < 0.0F, -front, front);
  points.position = p0 + (u * side1 + v * side2);
  const Floats largest_term =
      has_instances_ ? largest_term_.load() : largest_coordinate(p0, p1, p2);
  const Floats roundings =
      has_instances_ ? roundings_.load() : all_lanes(Triangle::usual_roundings);
  points.rounding_error = rounding_error_of(largest_term, roundings, side1, side2);
  points.origin = origin_before(points.position, direction, points.geometric_normal,
                                distance_.load(), points.rounding_error);
  const Vec3s between =
      (1.0F - u - v) * normals_.p0.load() + u * normals_.p1.load() + v * normals_.p2.load();
  points.smooth_normal = normalized_or(between, front);
  const Floats side = dot(points.smooth_normal, points.geometric_normal);
  const Vec3s shading = with_sign(1.0F, side) * points.smooth_normal;
  points.shading_normal = chosen(dot(shading, direction) < 0.0F, shading, points.geometric_normal);
  return points;
}

}  // namespace foveola
