#include "renderer/stability/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/random.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

constexpr int batches = 32;

int blocks_across(const PictureSettings& settings) { return settings.width / settings.block; }

std::size_t block_of(const PictureSettings& settings, std::uint32_t pixel) {
  const int x = static_cast<int>(pixel) % settings.width / settings.block;
  const int y = static_cast<int>(pixel) / settings.width / settings.block;
  return static_cast<std::size_t>(y * blocks_across(settings) + x);
}

std::vector<SampleJob> jobs_of(const PictureSettings& settings, std::uint32_t seed, int count) {
  std::vector<SampleJob> jobs;
  const auto width = static_cast<std::uint32_t>(settings.width);
  const auto pixels = width * static_cast<std::uint32_t>(settings.height);
  jobs.reserve(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(count));
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    const Vec2 corner(pixel % width, pixel / width);
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
      const Vec2 place = corner + sobol_2d(i, mix(mix(seed), pixel));
      jobs.push_back(
          {.direction = direction_from_equirect(place / Vec2(settings.width, settings.height)),
           .pixel = pixel,
           .sample_number = i});
    }
  }
  return jobs;
}

}  // namespace

std::vector<RadianceEstimate> render_blocks(const PathTracer& tracer, const Vec3& viewpoint,
                                            const PictureSettings& settings,
                                            const StabilityRun& run) {
  const int blocks = blocks_across(settings) * (settings.height / settings.block);
  const int samples_each = std::max(1, run.effort.picture_samples_per_pixel / batches);
  const double block_samples = static_cast<double>(samples_each) * settings.block * settings.block;
  // By block, then by batch.
  std::vector<std::vector<DVec3>> means(static_cast<std::size_t>(blocks),
                                        std::vector<DVec3>(batches, DVec3(0.0)));
  std::vector<Rgb> radiance;
  for (std::uint32_t batch = 0; batch < batches && !run.stop.stop_requested(); ++batch) {
    const std::uint32_t seed = settings.seed * batches + batch;
    const std::vector<SampleJob> jobs = jobs_of(settings, seed, samples_each);
    radiance.resize(jobs.size());
    tracer.trace(viewpoint, jobs, radiance, {.max_depth = settings.max_depth, .seed = seed},
                 run.workers);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      means[block_of(settings, jobs[i].pixel)][batch] += DVec3(radiance[i]) / block_samples;
    }
  }
  std::vector<RadianceEstimate> estimates;
  for (const std::vector<DVec3>& of_batches : means) {
    estimates.push_back(mean_of_batches(of_batches));
    estimates.back().samples = static_cast<std::uint64_t>(block_samples) * batches;
  }
  return estimates;
}

StabilityFigure picture_difference(std::string name, const std::vector<RadianceEstimate>& picture,
                                   const std::vector<RadianceEstimate>& reference,
                                   double exactness) {
  assert(picture.size() == reference.size());
  StabilityFigure figure{.name = std::move(name),
                         .measured = 0.0,
                         .bound = standard_errors_allowed,
                         .unit = "standard errors",
                         .details = {}};
  double sum = 0.0;
  double reference_sum = 0.0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = reference[i].mean[channel];
      const double off = std::abs(picture[i].mean[channel] - expected);
      const double noise =
          std::hypot(picture[i].standard_error[channel], reference[i].standard_error[channel]);
      const double beyond = off - exactness * expected;
      const double score = beyond <= 0.0 ? 0.0 : beyond / noise;
      sum += picture[i].mean[channel];
      reference_sum += expected;
      if (!(score <= figure.measured)) {  // also where it is not a number
        figure.measured = score;
        figure.details = fmt::format("block {}: {:.5f} against {:.5f}, standard error {:.2g}", i,
                                     picture[i].mean[channel], expected, noise);
        if (std::isnan(score)) {
          return figure;
        }
      }
    }
  }
  figure.details += fmt::format("; whole picture: {:+.3f} %", 100.0 * (sum / reference_sum - 1.0));
  return figure;
}

}  // namespace foveola
