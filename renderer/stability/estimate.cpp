#include "renderer/stability/estimate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/base/transformed.h"
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

constexpr std::uint32_t batches = 64;
constexpr std::uint32_t smallest_batch = 16;   ///< samples of each batch
constexpr std::uint32_t largest_batch = 8192;  ///< a batch's jobs then stay in memory

constexpr double percent = 100.0;

/// Sums of radiance that are continued batch by batch.
class Batches {
 public:
  Batches(const PathTracer& tracer, const Measurement& measurement, const Workers& workers)
      : tracer_(tracer), measurement_(measurement), workers_(workers), sums_(batches, DVec3(0.0)) {}

  /// Adds `count` samples to every batch.
  void add(std::uint32_t count) {
    jobs_.clear();
    for (std::uint32_t batch = 0; batch < batches; ++batch) {
      for (std::uint32_t i = done_; i < done_ + count; ++i) {
        jobs_.push_back({.direction = measurement_.direction(sobol_2d(i, batch)),
                         .pixel = batch,
                         .sample_number = i});
      }
    }
    radiance_.resize(jobs_.size());
    tracer_.trace(measurement_.viewpoint, jobs_, radiance_,
                  {.max_depth = measurement_.max_depth, .seed = 1}, workers_);
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      sums_[jobs_[i].pixel] += DVec3(radiance_[i]);
    }
    done_ += count;
  }

  std::uint32_t samples_each() const { return done_; }

  RadianceEstimate estimate() const {
    const std::vector<DVec3> means =
        transformed(sums_, [&](const DVec3& sum) { return sum / static_cast<double>(done_); });
    RadianceEstimate estimate = mean_of_batches(means);
    estimate.samples = std::uint64_t{done_} * batches;
    return estimate;
  }

 private:
  const PathTracer& tracer_;
  const Measurement& measurement_;
  const Workers& workers_;
  std::vector<DVec3> sums_;
  std::uint32_t done_ = 0;
  std::vector<SampleJob> jobs_;
  std::vector<Rgb> radiance_;
};

double largest(const DVec3& v) { return std::max(v.x, std::max(v.y, v.z)); }

bool is_number(const DVec3& v) { return !std::isnan(v.x + v.y + v.z); }

/// A figure relative to its bound; infinite if it could not be measured.
double severity(const StabilityFigure& figure) {
  if (std::isnan(figure.measured)) {
    return std::numeric_limits<double>::infinity();
  }
  return figure.measured == 0.0 ? 0.0 : figure.measured / figure.bound;
}

bool is_milder(const StabilityFigure& a, const StabilityFigure& b) {
  return severity(a) < severity(b);
}

std::string describe(const RadianceEstimate& estimate, int channel, double expected) {
  return fmt::format("{:.6f} against {:.6f}, standard error {:.2g}, {} samples",
                     estimate.mean[channel], expected, estimate.standard_error[channel],
                     estimate.samples);
}

}  // namespace

RadianceEstimate mean_of_batches(const std::vector<DVec3>& batch_means) {
  const auto n = static_cast<double>(batch_means.size());
  DVec3 mean(0.0);
  for (const DVec3& value : batch_means) {
    mean += value / n;
  }
  DVec3 squares(0.0);
  for (const DVec3& value : batch_means) {
    squares += (value - mean) * (value - mean);
  }
  return {.mean = mean, .standard_error = glm::sqrt(squares / (n - 1.0) / n)};
}

Vec3 uniform_direction(const Vec2& u) {
  return direction_from(
      {.azimuth_rad = 2.0 * std::numbers::pi * u.x, .elevation_rad = std::asin(2.0 * u.y - 1.0)});
}

std::vector<SampleJob> uniform_jobs(std::uint32_t count, std::uint32_t seed) {
  std::vector<SampleJob> jobs;
  jobs.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    jobs.push_back({.direction = uniform_direction(sobol_2d(i, seed)), .pixel = i});
  }
  return jobs;
}

Measurement single_ray(const Vec3& viewpoint, const Vec3& direction, int max_depth,
                       double expected) {
  return {.viewpoint = viewpoint,
          .direction = [unit = glm::normalize(direction)](const Vec2&) { return unit; },
          .max_depth = max_depth,
          .expected = expected};
}

RadianceEstimate measure(const PathTracer& tracer, const Measurement& measurement,
                         const StabilityRun& run) {
  Batches sums(tracer, measurement, run.workers);
  const double target = run.effort.tolerance * measurement.expected / standard_errors_allowed;
  for (std::uint32_t round = smallest_batch;;
       round = std::min(sums.samples_each(), largest_batch)) {
    sums.add(round);
    const RadianceEstimate estimate = sums.estimate();
    const bool is_done = !is_number(estimate.mean) || largest(estimate.standard_error) < target ||
                         estimate.samples >= run.effort.max_samples;
    if (is_done || run.stop.stop_requested()) {
      return estimate;
    }
  }
}

StabilityFigure deviation(std::string name, const RadianceEstimate& estimate, const DVec3& expected,
                          double rounding_allowance, double tolerance) {
  std::vector<StabilityFigure> channels;
  for (int channel = 0; channel < 3; ++channel) {
    const double truth = expected[channel];
    const double noise = standard_errors_allowed * estimate.standard_error[channel] / truth;
    channels.push_back({.name = {},
                        .measured = percent * std::abs(estimate.mean[channel] - truth) / truth,
                        .bound = percent * (rounding_allowance + std::min(tolerance, noise)),
                        .unit = "%",
                        .details = describe(estimate, channel, truth)});
  }
  StabilityFigure figure = *std::ranges::max_element(channels, is_milder);
  figure.name = std::move(name);
  return figure;
}

StabilityFigure excess(std::string name, const RadianceEstimate& estimate, double limit,
                       double rounding_allowance, double tolerance) {
  int brightest = 0;
  for (int channel = 1; channel < 3; ++channel) {
    brightest = estimate.mean[channel] > estimate.mean[brightest] ? channel : brightest;
  }
  const double noise = standard_errors_allowed * estimate.standard_error[brightest] / limit;
  const double above = is_number(estimate.mean)
                           ? std::max(0.0, estimate.mean[brightest] / limit - 1.0)
                           : std::numeric_limits<double>::quiet_NaN();
  return {.name = std::move(name),
          .measured = percent * above,
          .bound = percent * (rounding_allowance + std::min(tolerance, noise)),
          .unit = "%",
          .details = describe(estimate, brightest, limit)};
}

StabilityFigure worst_of(std::string name, const std::vector<StabilityFigure>& figures) {
  assert(!figures.empty());
  const StabilityFigure& worst = *std::ranges::max_element(figures, is_milder);
  StabilityFigure figure = worst;
  figure.name = std::move(name);
  figure.details = fmt::format("worst of {}: {}: {}", figures.size(), worst.name, worst.details);
  return figure;
}

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
                                   double rounding_allowance) {
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
      const double beyond = off - rounding_allowance * expected;
      const double score = beyond <= 0.0 ? 0.0 : beyond / noise;
      sum += picture[i].mean[channel];
      reference_sum += expected;
      if (!(score <= figure.measured)) {  // also if it is NaN
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
