// One progressive render whose time is taken: only sampling, tracing and filming count.
#pragma once

#include <cstdint>
#include <memory>

#include "analysis/convergence/plan.h"
#include "renderer/film/equirect_film.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {

/// Looks at one gaze with the head behind it. It refers to its subject, which must have a tracer
/// for the configuration, and to the workers; both must outlive it.
class ProgressiveRun {
 public:
  ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                 const Configuration& configuration, const Aim& aim, std::uint32_t seed,
                 const Workers& workers);

  /// Takes so many samples more.
  void advance(std::uint64_t samples);

  /// Those left out by adaptive sampling count as taken.
  std::uint64_t samples() const { return render_.points_drawn(); }
  /// The time that advance() has taken in all.
  double seconds() const { return seconds_; }
  /// Samples dropped because they were not finite.
  std::uint64_t dropped() const { return render_.dropped().size(); }
  const EquirectFilm& film() const { return render_.film(); }

 private:
  Vec3 gaze_;
  bool is_adaptive_;
  std::unique_ptr<ViewSampler> sampler_;
  ProgressiveRender render_;
  double seconds_ = 0.0;
};

}  // namespace foveola::analysis
