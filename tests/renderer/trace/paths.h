// Paths for the tests of the tracer: jobs, their radiance, and its mean.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/trace/paths/path_tracer.h"
#include "statistics.h"

namespace foveola {

inline const Workers& workers() {
  static const Workers four(4);
  return four;
}

inline std::vector<SampleJob> jobs_along(const Vec3& direction, std::uint32_t count) {
  std::vector<SampleJob> jobs;
  for (std::uint32_t i = 0; i < count; ++i) {
    jobs.push_back({.direction = glm::normalize(direction), .pixel = i, .sample_number = 0});
  }
  return jobs;
}

inline std::vector<SampleJob> jobs_all_around(std::uint32_t count) {
  std::vector<SampleJob> jobs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec2 u = sobol_2d(i, 17);
    jobs.push_back({.direction = direction_from({.azimuth_rad = 2.0 * std::numbers::pi * u.x,
                                                 .elevation_rad = std::asin(2.0 * u.y - 1.0)}),
                    .pixel = i % 100,
                    .sample_number = i / 100});
  }
  return jobs;
}

inline std::vector<Rgb> trace(const PathTracer& tracer, const Vec3& viewpoint,
                              const std::vector<SampleJob>& jobs, int max_depth) {
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, {.max_depth = max_depth, .seed = 1}, workers());
  return radiance;
}

inline MeanEstimate mean_of(const std::vector<Rgb>& radiance) {
  MeanEstimate mean;
  for (const Rgb& value : radiance) {
    mean.add(value.g);
  }
  return mean;
}

inline MeanEstimate mean_radiance(const Scene& scene, const Vec3& viewpoint, const Vec3& direction,
                                  int max_depth, std::uint32_t samples) {
  return mean_of(
      trace(PathTracer(scene, workers()), viewpoint, jobs_along(direction, samples), max_depth));
}

}  // namespace foveola
