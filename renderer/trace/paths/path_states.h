// States of a block's paths between two vertices, as columns that are read and written eight at a
// time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/numbers/lane_columns.h"
#include "renderer/base/numbers/lanes.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

/// One path between two vertices.
struct Path {
  Ray ray;
  Rgb throughput{1.0F};
  float pdf = 0.0F;            ///< per steradian, of the direction at the last vertex
  ShadingPoint shading_point;  ///< the last vertex; unused before the first
  /// Weight of radiance from infinity if the pdf is `certain`: see
  /// BlockTracer::distant_weight_beyond().
  float distant_weight = 1.0F;
  float radiance_scale = 1.0F;  ///< product of refraction's factors on the throughput
  Rgb absorption_per_m{0.0F};   ///< of the solid around the path
  float width_m = 0.0F;         ///< the ray's width at its origin
  float spread_rad = 0.0F;      ///< the angle of the ray's widening
  SampleStream random;
  std::uint32_t job = 0;  ///< index of the path's job
};

/// Member i of everything belongs to path i.
struct PathStates {
  static constexpr std::size_t capacity = 512;
  using Vectors = Vec3Columns<capacity>;
  using Numbers = FloatColumn<capacity>;

  Vectors origin, direction, throughput, shading_point_position, shading_point_normal,
      absorption_per_m;
  Numbers pdf, distant_weight, radiance_scale, width_m, spread_rad;
  UintColumn<capacity> shading_point_transmits;  ///< 0: no
  UintColumn<capacity> shading_point_region;
  UintColumn<capacity> key, job;
  SampleStreamColumns<capacity> random;

  Path at(std::size_t i) const {
    Path path{.throughput = throughput.at(i),
              .pdf = pdf[i],
              .shading_point = {.position = shading_point_position.at(i),
                                .normal = shading_point_normal.at(i),
                                .transmits = shading_point_transmits[i] != 0,
                                .region = shading_point_region[i]},
              .distant_weight = distant_weight[i],
              .radiance_scale = radiance_scale[i],
              .absorption_per_m = absorption_per_m.at(i),
              .width_m = width_m[i],
              .spread_rad = spread_rad[i],
              .random = random.at(i),
              .job = job[i]};
    path.ray.origin = origin.at(i);
    path.ray.direction = direction.at(i);
    path.ray.key = key[i];
    return path;
  }
  /// Sets all paths to `path`; members that differ are written afterwards.
  void fill(const Path& path) {
    origin.fill(path.ray.origin);
    throughput.fill(path.throughput);
    pdf.fill(path.pdf);
    shading_point_position.fill(path.shading_point.position);
    shading_point_normal.fill(path.shading_point.normal);
    shading_point_transmits.fill(path.shading_point.transmits ? 1U : 0U);
    shading_point_region.fill(path.shading_point.region);
    distant_weight.fill(path.distant_weight);
    radiance_scale.fill(path.radiance_scale);
    absorption_per_m.fill(path.absorption_per_m);
    width_m.fill(path.width_m);
    spread_rad.fill(path.spread_rad);
  }
  /// The path's ray must begin at its origin.
  void put(std::size_t i, const Path& path) {
    origin.put(i, path.ray.origin);
    direction.put(i, path.ray.direction);
    key[i] = path.ray.key;
    throughput.put(i, path.throughput);
    pdf[i] = path.pdf;
    shading_point_position.put(i, path.shading_point.position);
    shading_point_normal.put(i, path.shading_point.normal);
    shading_point_transmits[i] = path.shading_point.transmits ? 1U : 0U;
    shading_point_region[i] = path.shading_point.region;
    distant_weight[i] = path.distant_weight;
    radiance_scale[i] = path.radiance_scale;
    absorption_per_m.put(i, path.absorption_per_m);
    width_m[i] = path.width_m;
    spread_rad[i] = path.spread_rad;
    random.put(i, path.random);
    job[i] = path.job;
  }

  /// Moves the staying paths of the eight at `first` to `to`, which is not behind `first`.
  void move(std::size_t first, const LanePacking& packing, std::size_t to) {
    for (Vectors* vectors : {&origin, &direction, &throughput, &shading_point_position,
                             &shading_point_normal, &absorption_per_m}) {
      vectors->move(first, packing, to);
    }
    for (Numbers* numbers : {&pdf, &distant_weight, &radiance_scale, &width_m, &spread_rad}) {
      numbers->move(first, packing, to);
    }
    for (UintColumn<capacity>* numbers :
         {&shading_point_transmits, &shading_point_region, &key, &job}) {
      numbers->move(first, packing, to);
    }
    random.move(first, packing, to);
  }
};

/// Hits of the paths' rays.
struct PathHits {
  static constexpr std::size_t capacity = PathStates::capacity;

  FloatColumn<capacity> t, u, v;
  UintColumn<capacity> object, triangle;

  Hit at(std::size_t i) const {
    return {.t = t[i], .barycentric = {u[i], v[i]}, .object = object[i], .triangle = triangle[i]};
  }
  void put(std::size_t i, const Hit& hit) {
    t[i] = hit.t;
    u[i] = hit.barycentric.x;
    v[i] = hit.barycentric.y;
    object[i] = hit.object;
    triangle[i] = hit.triangle;
  }
  /// The lanes of the eight from `first` that hit a surface.
  LaneMask met_surface(std::size_t first) const {
    return LaneMask(object.load(first) != Hit::nothing);
  }
  void store(std::size_t first, const HitQueries& found) {
    t.store(first, found.rays.t_max.load());
    u.store(first, found.u.load());
    v.store(first, found.v.load());
    object.store(first, found.object());
    triangle.store(first, found.triangle.load());
  }
};

}  // namespace foveola
