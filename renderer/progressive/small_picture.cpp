#include "renderer/progressive/small_picture.h"

#include "renderer/base/random.h"

namespace foveola {
namespace {

/// The samples of each pixel after those of the pixel before.
std::vector<SampleJob> jobs_through(const Viewport& viewport,
                                    const SmallPictureSettings& settings) {
  const IVec2& size = settings.size;
  std::vector<SampleJob> jobs;
  jobs.reserve(static_cast<std::size_t>(size.x) * size.y * settings.samples_per_pixel);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const auto pixel = static_cast<std::uint32_t>(y * size.x + x);
      for (std::uint32_t sample = 0; sample < settings.samples_per_pixel; ++sample) {
        const Vec2 place = sobol_2d(sample, mix(settings.trace.seed, pixel));
        jobs.push_back({.direction = viewport.direction((Vec2(x, y) + place) / Vec2(size)),
                        .pixel = pixel,
                        .sample_number = sample});
      }
    }
  }
  return jobs;
}

}  // namespace

std::vector<DVec3> small_picture(const PathTracer& tracer, const Vec3& viewpoint,
                                 const Viewport& viewport, SmallPictureSettings settings,
                                 const Workers& workers) {
  settings.trace.pixel_angle_rad =
      static_cast<float>(2.0 * viewport.half_size().x / settings.size.x);
  const std::vector<SampleJob> jobs = jobs_through(viewport, settings);
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, settings.trace, workers);
  std::vector<DVec3> means(static_cast<std::size_t>(settings.size.x) * settings.size.y);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (is_finite(radiance[i])) {
      means[jobs[i].pixel] += DVec3(radiance[i]);
    }
  }
  for (DVec3& mean : means) {
    mean /= settings.samples_per_pixel;
  }
  return means;
}

}  // namespace foveola
