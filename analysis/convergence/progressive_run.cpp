#include "analysis/convergence/progressive_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "renderer/base/clock.h"

namespace foveola::analysis {
namespace {

const PathTracer& tracer_for(const Configuration& configuration, const Subject& subject) {
  const PathTracer* tracer = subject.tracer_for(configuration.light_sampling);
  assert(tracer != nullptr);
  return *tracer;
}

ProgressiveSettings settings_for(const Configuration& configuration, const ConvergencePlan& plan,
                                 const SceneSource& source, std::uint32_t seed) {
  const auto white = static_cast<float>(std::exp2(-source.exposure_stops.value_or(0.0)));
  ProgressiveSettings settings;
  settings.film_size = plan.size;
  settings.trace = {.max_depth = plan.max_depth,
                    .seed = seed,
                    .largest_radiance = configuration.largest_radiance,
                    .largest_light_sample = white * configuration.largest_light_sample,
                    .vertices_before_roulette = configuration.vertices_before_roulette,
                    .light_samples_alone = configuration.light_samples_alone,
                    .uses_general_path = configuration.uses_general_path};
  settings.numbers = configuration.numbers;
  if (configuration.adaptive_contrast) {
    settings.adaptive = VisibleNoise{.contrast = *configuration.adaptive_contrast};
  }
  return settings;
}

}  // namespace

ProgressiveRun::ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                               const Configuration& configuration, const Aim& aim,
                               std::uint32_t seed, const Workers& workers)
    : gaze_(aim.gaze),
      is_adaptive_(configuration.adaptive_contrast.has_value()),
      sampler_(make_view_sampler(configuration.method)),
      render_(tracer_for(configuration, subject),
              subject.loaded.rendered_with(
                  settings_for(configuration, plan, subject.loaded.source, seed)),
              workers) {
  sampler_->aim(aim);
}

void ProgressiveRun::advance(std::uint64_t samples) {
  const SteadyClock clock;
  const Nanoseconds start = clock.now();
  const std::uint64_t end = render_.points_drawn() + samples;
  while (render_.points_drawn() < end) {
    const std::uint64_t left = end - render_.points_drawn();
    render_.look_at(gaze_);
    render_.advance(*sampler_, is_adaptive_ ? std::min(left, adaptive_pass) : left);
  }
  seconds_ += foveola::seconds(clock.now() - start);
}

}  // namespace foveola::analysis
