// The paths of a block between two vertices, side by side, so that eight are read or written at
// once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/base/lanes.h"
#include "renderer/base/random.h"
#include "renderer/base/vec.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/shading_point.h"

namespace foveola {

/// One path between two vertices.
struct Path {
  Ray ray;
  Rgb throughput{1.0F};
  float pdf = 0.0F;             ///< per steradian, with which the last vertex gave the direction
  ShadingPoint shading_point;   ///< the last vertex; unused before the first
  float radiance_scale = 1.0F;  ///< what refraction has scaled the throughput by
  Rgb absorption_per_m{0.0F};   ///< in the solid that the path is in
  float width_m = 0.0F;         ///< the ray's width at its origin
  float spread_rad = 0.0F;      ///< the angle by which the ray widens
  SampleStream random;
  std::uint32_t job = 0;  ///< that the path is for
};

/// Member i of everything belongs to path i.
struct PathStates {
  static constexpr std::size_t capacity = 512;

  struct alignas(lane_count * sizeof(float)) Numbers : std::array<float, capacity> {
    Floats load(std::size_t first) const {
      Floats lanes;
      __builtin_memcpy(&lanes, data() + first, sizeof(lanes));
      return lanes;
    }
    void store(std::size_t first, const Floats& lanes) {
      __builtin_memcpy(data() + first, &lanes, sizeof(lanes));
    }
    /// Leaves the lanes that are not in the mask as they are.
    void store(std::size_t first, const LaneMask& mask, const Floats& lanes) {
      store(first, mask ? lanes : load(first));
    }
  };
  struct Vectors {
    Numbers x, y, z;

    void fill(const Vec3& v) {
      x.fill(v.x);
      y.fill(v.y);
      z.fill(v.z);
    }
    Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void put(std::size_t i, const Vec3& v) {
      x[i] = v.x;
      y[i] = v.y;
      z[i] = v.z;
    }
    Vec3s load(std::size_t first) const { return {x.load(first), y.load(first), z.load(first)}; }
    void store(std::size_t first, const LaneMask& mask, const Vec3s& lanes) {
      x.store(first, mask, lanes.x);
      y.store(first, mask, lanes.y);
      z.store(first, mask, lanes.z);
    }
  };

  Vectors origin, direction, throughput, shading_point_position, shading_point_normal,
      absorption_per_m;
  Numbers pdf, radiance_scale, width_m, spread_rad;
  std::array<bool, capacity> shading_point_transmits;
  std::array<std::uint32_t, capacity> key, job;
  std::array<SampleStream, capacity> random;

  Ray ray(std::size_t i) const {
    Ray ray{.origin = origin.at(i), .direction = direction.at(i)};
    ray.key = key[i];
    return ray;
  }
  Path at(std::size_t i) const {
    return {.ray = ray(i),
            .throughput = throughput.at(i),
            .pdf = pdf[i],
            .shading_point = {.position = shading_point_position.at(i),
                              .normal = shading_point_normal.at(i),
                              .transmits = shading_point_transmits[i]},
            .radiance_scale = radiance_scale[i],
            .absorption_per_m = absorption_per_m.at(i),
            .width_m = width_m[i],
            .spread_rad = spread_rad[i],
            .random = random[i],
            .job = job[i]};
  }
  /// What is the same for all paths; what is their own is to be written after.
  void fill(const Path& path) {
    origin.fill(path.ray.origin);
    throughput.fill(path.throughput);
    pdf.fill(path.pdf);
    shading_point_position.fill(path.shading_point.position);
    shading_point_normal.fill(path.shading_point.normal);
    shading_point_transmits.fill(path.shading_point.transmits);
    radiance_scale.fill(path.radiance_scale);
    absorption_per_m.fill(path.absorption_per_m);
    width_m.fill(path.width_m);
    spread_rad.fill(path.spread_rad);
  }
  /// Its ray must begin at its origin.
  void put(std::size_t i, const Path& path) {
    origin.put(i, path.ray.origin);
    direction.put(i, path.ray.direction);
    key[i] = path.ray.key;
    throughput.put(i, path.throughput);
    pdf[i] = path.pdf;
    shading_point_position.put(i, path.shading_point.position);
    shading_point_normal.put(i, path.shading_point.normal);
    shading_point_transmits[i] = path.shading_point.transmits;
    radiance_scale[i] = path.radiance_scale;
    absorption_per_m.put(i, path.absorption_per_m);
    width_m[i] = path.width_m;
    spread_rad[i] = path.spread_rad;
    random[i] = path.random;
    job[i] = path.job;
  }
};

}  // namespace foveola
