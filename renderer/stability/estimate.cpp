#include "renderer/stability/estimate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/random.h"

namespace foveola {
namespace {

constexpr std::uint32_t batches = 64;
constexpr std::uint32_t smallest_batch = 16;   ///< samples of each batch
constexpr std::uint32_t largest_batch = 8192;  ///< so many that a batch's jobs stay in memory

constexpr double percent = 100.0;

/// Sums of radiance that can be continued batch after batch.
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
    std::vector<DVec3> means;
    for (const DVec3& sum : sums_) {
      means.push_back(sum / static_cast<double>(done_));
    }
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

/// How much of its bound a figure takes up; infinite where it could not be measured.
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

Vec3 direction_all_around(const Vec2& u) {
  return direction_from(
      {.azimuth_rad = 2.0 * std::numbers::pi * u.x, .elevation_rad = std::asin(2.0 * u.y - 1.0)});
}

std::vector<SampleJob> jobs_all_around(std::uint32_t count, std::uint32_t seed) {
  std::vector<SampleJob> jobs;
  jobs.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    jobs.push_back({.direction = direction_all_around(sobol_2d(i, seed)), .pixel = i});
  }
  return jobs;
}

Measurement along(const Vec3& viewpoint, const Vec3& direction, int max_depth, double expected) {
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
                         estimate.samples >= run.effort.most_samples;
    if (is_done || run.stop.stop_requested()) {
      return estimate;
    }
  }
}

StabilityFigure deviation(std::string name, const RadianceEstimate& estimate, const DVec3& expected,
                          double exactness, double tolerance) {
  std::vector<StabilityFigure> channels;
  for (int channel = 0; channel < 3; ++channel) {
    const double truth = expected[channel];
    const double noise = standard_errors_allowed * estimate.standard_error[channel] / truth;
    channels.push_back({.name = {},
                        .measured = percent * std::abs(estimate.mean[channel] - truth) / truth,
                        .bound = percent * (exactness + std::min(tolerance, noise)),
                        .unit = "%",
                        .details = describe(estimate, channel, truth)});
  }
  StabilityFigure figure = *std::max_element(channels.begin(), channels.end(), is_milder);
  figure.name = std::move(name);
  return figure;
}

StabilityFigure excess(std::string name, const RadianceEstimate& estimate, double limit,
                       double exactness, double tolerance) {
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
          .bound = percent * (exactness + std::min(tolerance, noise)),
          .unit = "%",
          .details = describe(estimate, brightest, limit)};
}

StabilityFigure worst_of(std::string name, const std::vector<StabilityFigure>& figures) {
  assert(!figures.empty());
  const StabilityFigure& worst = *std::max_element(figures.begin(), figures.end(), is_milder);
  StabilityFigure figure = worst;
  figure.name = std::move(name);
  figure.details = fmt::format("worst of {}: {}: {}", figures.size(), worst.name, worst.details);
  return figure;
}

}  // namespace foveola
