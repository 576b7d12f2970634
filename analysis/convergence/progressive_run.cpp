#include "analysis/convergence/progressive_run.h"

#include <algorithm>

#include "renderer/base/clock.h"
#include "renderer/base/random.h"
#include "renderer/view/equirect.h"

namespace foveola::analysis {
namespace {

/// Keeps the pattern of the directions apart from the randomness of the paths.
constexpr std::uint32_t view_stream = 0x76696577U;

/// After so many samples it is looked at again what is done, as in a render.
constexpr std::uint64_t adaptive_batch = 1 << 16;

/// Points that one task draws.
constexpr std::size_t point_block = 4096;

}  // namespace

TraceSettings trace_settings(const ConvergencePlan& plan, std::uint32_t seed) {
  return {
      .max_depth = plan.max_depth, .seed = seed, .pixel_angle_rad = pixel_angle_rad(plan.size.x)};
}

ProgressiveRun::ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                               const Configuration& configuration, const Aim& aim,
                               std::uint32_t seed, const Workers& workers)
    : subject_(&subject),
      tracer_(configuration.light_selection == LightSelection::usual
                  ? subject.tracer
                  : subject.tracer_by_power_alone),
      workers_(&workers),
      gaze_(aim.gaze),
      numbers_(configuration.numbers),
      trace_(trace_settings(plan, seed)),
      sampler_(make_view_sampler(configuration.method)),
      film_(plan.size.x, plan.size.y,
            configuration.adaptive_contrast ? FilmStatistics::mean_and_variance
                                            : FilmStatistics::mean) {
  trace_.largest_radiance = configuration.largest_radiance;
  trace_.uses_general_path = configuration.uses_general_path;
  if (configuration.adaptive_contrast) {
    adaptive_ = VisibleNoise{.contrast = *configuration.adaptive_contrast,
                             .exposure_stops = subject.exposure_stops};
  }
  sampler_->aim(aim);
}

void ProgressiveRun::advance(std::uint64_t samples) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  for (std::uint64_t left = samples; left > 0;) {
    const std::uint64_t batch = adaptive_ ? std::min(left, adaptive_batch) : left;
    numbers_ == RandomNumbers::independent ? advance_independent(batch) : advance_sequence(batch);
    samples_ += batch;
    left -= batch;
  }
  seconds_ += foveola::seconds(clock.now() - start);
}

void ProgressiveRun::advance_sequence(std::uint64_t samples) {
  const auto trace = [this](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
    tracer_->trace(subject_->viewpoint, jobs, radiance, trace_, *workers_);
  };
  const SobolRange points = {
      .first = samples_, .count = samples, .seed = mix(trace_.seed, view_stream)};
  dropped_ += pass_.run(*sampler_, points, trace, film_, *workers_, adjust()).size();
}

SamplePass::Adjust ProgressiveRun::adjust() {
  if (!adaptive_) {
    return {};
  }
  const std::uint32_t seed = mix(mix(trace_.seed, view_stream), ++batches_);
  return [this, seed](std::vector<ViewSample>& samples) {
    redirect_samples(film_, gaze_, *adaptive_, seed, samples, *workers_);
  };
}

void ProgressiveRun::advance_independent(std::uint64_t samples) {
  points_.resize(samples);
  view_samples_.resize(samples);
  radiance_.resize(samples);
  workers_->for_each_block(samples, point_block, [this](std::size_t begin, std::size_t end) {
    Pcg32 generator(mix(trace_.seed, view_stream), samples_ + begin);
    for (std::size_t i = begin; i < end; ++i) {
      points_[i].x = unit_float(generator.next());
      points_[i].y = unit_float(generator.next());
    }
    sampler_->sample(std::span(points_).subspan(begin, end - begin),
                     std::span(view_samples_).subspan(begin, end - begin));
  });
  film_.number(view_samples_, batch_, *workers_);
  // A path's numbers run through a sequence over the samples of its pixel. The first sample of a
  // pixel that no other path has is independent of all others'.
  for (SampleJob& job : batch_.jobs) {
    job.pixel = mix(job.pixel, job.sample_number);
    job.sample_number = 0;
  }
  tracer_->trace(subject_->viewpoint, batch_.jobs, radiance_, trace_, *workers_);
  dropped_ += film_.add(batch_, radiance_, *workers_).size();
}

}  // namespace foveola::analysis
