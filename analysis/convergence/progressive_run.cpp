#include "analysis/convergence/progressive_run.h"

#include <algorithm>

#include "renderer/base/clock.h"

namespace foveola::analysis {
namespace {

const PathTracer& tracer_for(const Configuration& configuration, const Subject& subject) {
  return configuration.light_selection == LightSelection::usual ? subject.loaded.tracer
                                                                : *subject.tracer_by_power_alone;
}

ProgressiveSettings settings_for(const Configuration& configuration, const ConvergencePlan& plan,
                                 std::uint32_t seed) {
  ProgressiveSettings settings;
  settings.film_size = plan.size;
  settings.trace = {.max_depth = plan.max_depth,
                    .seed = seed,
                    .largest_radiance = configuration.largest_radiance,
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
              subject.loaded.rendered_with(settings_for(configuration, plan, seed)), workers) {
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
