#include "renderer/progressive/progressive_render.h"

#include <algorithm>

#include "renderer/base/clock.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Separates the directions' pattern from the randomness of the paths.
constexpr std::uint32_t view_stream = 0x76696577U;

FilmStatistics statistics_for(const ProgressiveSettings& settings) {
  return settings.adaptive || settings.keep_variances ? FilmStatistics::mean_and_variance
                                                      : FilmStatistics::mean;
}

/// A path's numbers follow a sequence over the samples of its pixel. The first sample of a pixel
/// without other paths is independent of all others'.
std::vector<SampleJob> independent_of_each_other(std::span<const SampleJob> jobs) {
  std::vector<SampleJob> independent(jobs.begin(), jobs.end());
  for (SampleJob& job : independent) {
    job.pixel = mix(job.pixel, job.sample_number);
    job.sample_number = 0;
  }
  return independent;
}

}  // namespace

ProgressiveRender::ProgressiveRender(const PathTracer& tracer, const ProgressiveSettings& settings,
                                     const Workers& workers)
    : tracer_(&tracer),
      workers_(&workers),
      settings_(settings),
      film_(settings.film_size.x, settings.film_size.y, statistics_for(settings)),
      pattern_seed_(mix(settings.trace.seed, view_stream)) {
  settings_.trace.pixel_angle_rad =
      settings.pixel_angle_rad.value_or(pixel_angle_rad(settings.film_size.x));
}

void ProgressiveRender::restart(std::uint32_t seed) {
  settings_.trace.seed = seed;
  begin_pattern(mix(seed, view_stream));
  looks_ = 0;
  dropped_.clear();
  film_.clear();
}

void ProgressiveRender::stand_at(const Vec3& viewpoint) {
  settings_.viewpoint = viewpoint;
  restart(settings_.trace.seed);
}

void ProgressiveRender::begin_pattern(std::uint32_t seed) {
  pattern_seed_ = seed;
  next_point_ = 0;
}

void ProgressiveRender::go_on_from(std::span<const PixelState> pixels, std::uint64_t points_drawn,
                                   std::vector<DroppedSample> dropped) {
  film_.restore(pixels, *workers_);
  next_point_ = points_drawn;
  dropped_ = std::move(dropped);
}

void ProgressiveRender::look_at(const Vec3& gaze) {
  gaze_ = gaze;
  ++looks_;
}

TracedSamples ProgressiveRender::advance(const ViewSampler& sampler, std::uint64_t points) {
  const std::span<const SampleJob> jobs = draw(sampler, points);
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  TracedSamples traced{.samples = jobs.size(), .rays = trace(jobs)};
  traced.trace_seconds = seconds(clock.now() - start);
  if (observe_) {
    observe_(jobs, radiance_);
  }
  add(sampler);
  return traced;
}

std::vector<SampleJob> ProgressiveRender::pass_over(const ViewSampler& sampler,
                                                    std::uint64_t points) {
  const std::span<const SampleJob> jobs = draw(sampler, points);
  if (settings_.adaptive) {
    trace(jobs);
  } else {
    radiance_.assign(jobs.size(), Rgb(0.0F));
  }
  add(sampler);
  return {jobs.begin(), jobs.end()};
}

std::optional<SampleJob> ProgressiveRender::find_job(const ViewSampler& sampler,
                                                     std::uint64_t points, std::uint32_t pixel,
                                                     std::uint32_t sample_number) {
  const std::vector<SampleJob> jobs = pass_over(sampler, points);
  const auto job = std::ranges::find_if(jobs, [&](const SampleJob& candidate) {
    return candidate.pixel == pixel && candidate.sample_number == sample_number;
  });
  return job != jobs.end() ? std::optional(*job) : std::nullopt;
}

std::span<const SampleJob> ProgressiveRender::draw(const ViewSampler& sampler,
                                                   std::uint64_t points) {
  const bool in_rounds = settings_.visits_pixels_in_rounds && sampler.keeps_points();
  std::vector<ViewSample>& samples =
      pass_.draw_samples(sampler,
                         {.first = next_point_,
                          .count = points,
                          .seed = pattern_seed_,
                          .numbers = settings_.numbers,
                          .cells = in_rounds ? settings_.film_size : IVec2(0)},
                         *workers_);
  next_point_ += points;
  if (settings_.adaptive) {
    redirect_samples(film_, gaze_, *settings_.adaptive, mix(pattern_seed_, looks_), samples,
                     *workers_);
  }
  if (filter_) {
    filter_(samples);
  }
  return pass_.number_samples(film_, *workers_);
}

RayCounts ProgressiveRender::trace(std::span<const SampleJob> jobs) {
  radiance_.resize(jobs.size());
  if (settings_.numbers == RandomNumbers::independent) {
    return tracer_->trace(settings_.viewpoint, independent_of_each_other(jobs), radiance_,
                          settings_.trace, *workers_);
  }
  return tracer_->trace(settings_.viewpoint, jobs, radiance_, settings_.trace, *workers_);
}

void ProgressiveRender::add(const ViewSampler& sampler) {
  const std::vector<DroppedSample> dropped =
      pass_.add_radiance(radiance_, settings_.adaptive ? nullptr : &sampler, film_, *workers_);
  dropped_.insert(dropped_.end(), dropped.begin(), dropped.end());
}

}  // namespace foveola
