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

constexpr int picture_batches = 32;

/// Pixels and blocks are numbered row by row from the top left.
struct Grid {
  std::uint32_t width;  ///< in pixels, of the picture
  std::uint32_t block;  ///< in pixels, along a side

  std::uint32_t pixels() const { return width * (width / 2); }
  std::uint32_t blocks() const { return pixels() / (block * block); }
  std::uint32_t block_of(std::uint32_t pixel) const {
    return pixel / width / block * (width / block) + pixel % width / block;
  }
};

std::vector<SampleJob> jobs_of(const Grid& grid, std::uint32_t seed, std::uint32_t samples_each) {
  std::vector<SampleJob> jobs;
  jobs.reserve(static_cast<std::size_t>(grid.pixels()) * samples_each);
  const auto width = static_cast<float>(grid.width);
  for (std::uint32_t pixel = 0; pixel < grid.pixels(); ++pixel) {
    const Vec2 corner(pixel % grid.width, pixel / grid.width);
    for (std::uint32_t i = 0; i < samples_each; ++i) {
      const Vec2 place = corner + sobol_2d(i, mix(mix(seed), pixel));
      jobs.push_back({.direction = direction_from_equirect(place / Vec2(width, 0.5F * width)),
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
  const Grid grid{.width = static_cast<std::uint32_t>(run.effort.picture_width),
                  .block = static_cast<std::uint32_t>(settings.block)};
  const auto samples_each = static_cast<std::uint32_t>(
      std::max(1, run.effort.picture_samples_per_pixel / picture_batches));
  const double block_samples = static_cast<double>(samples_each) * grid.block * grid.block;
  // Indexed by block, then by batch.
  std::vector<std::vector<DVec3>> means(grid.blocks(),
                                        std::vector<DVec3>(picture_batches, DVec3(0.0)));
  std::vector<Rgb> radiance;
  for (std::uint32_t batch = 0; batch < picture_batches && !run.stop.stop_requested(); ++batch) {
    const std::uint32_t seed = settings.seed * picture_batches + batch;
    const std::vector<SampleJob> jobs = jobs_of(grid, seed, samples_each);
    radiance.resize(jobs.size());
    tracer.trace(viewpoint, jobs, radiance, {.max_depth = settings.max_depth, .seed = seed},
                 run.workers);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      means[grid.block_of(jobs[i].pixel)][batch] += DVec3(radiance[i]) / block_samples;
    }
  }
  std::vector<RadianceEstimate> estimates;
  for (const std::vector<DVec3>& of_batches : means) {
    estimates.push_back(mean_of_batches(of_batches));
    estimates.back().samples = static_cast<std::uint64_t>(block_samples) * picture_batches;
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
