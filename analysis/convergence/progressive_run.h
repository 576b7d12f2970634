// One progressive render whose time is taken: nothing but directions, paths and film counts.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "analysis/convergence/plan.h"
#include "renderer/film/adaptive_sampling.h"
#include "renderer/film/equirect_film.h"
#include "renderer/film/sample_pass.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {

/// What a render with the plan asks of the tracer, as the shipped commands do.
TraceSettings trace_settings(const ConvergencePlan& plan, std::uint32_t seed);

/// Looks at one gaze with the head behind it. It refers to its subject, plan and workers, which
/// must outlive it.
class ProgressiveRun {
 public:
  ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                 const Configuration& configuration, const Aim& aim, std::uint32_t seed,
                 const Workers& workers);

  /// Takes so many samples more.
  void advance(std::uint64_t samples);

  std::uint64_t samples() const { return samples_; }
  /// That advance() has taken in all.
  double seconds() const { return seconds_; }
  /// Samples dropped because they were not finite.
  std::uint64_t dropped() const { return dropped_; }
  const EquirectFilm& film() const { return film_; }

 private:
  void advance_sequence(std::uint64_t samples);
  /// Takes away what its film says is done.
  SamplePass::Adjust adjust();
  void advance_independent(std::uint64_t samples);

  const Subject* subject_;
  const PathTracer* tracer_;
  const Workers* workers_;
  Vec3 gaze_;
  RandomNumbers numbers_;
  std::optional<VisibleNoise> adaptive_;
  TraceSettings trace_;
  std::unique_ptr<ViewSampler> sampler_;
  EquirectFilm film_;
  SamplePass pass_;
  std::vector<Vec2> points_;
  std::vector<ViewSample> view_samples_;
  NumberedBatch batch_;
  std::vector<Rgb> radiance_;
  std::uint32_t batches_ = 0;
  std::uint64_t samples_ = 0;
  std::uint64_t dropped_ = 0;
  double seconds_ = 0.0;
};

}  // namespace foveola::analysis
