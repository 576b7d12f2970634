// Measures errors of progressive renders, in alternating repetitions.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "analysis/convergence/convergence_plan.h"
#include "analysis/convergence/scorer.h"
#include "renderer/film/equirect_film.h"
#include "renderer/measure/region_error.h"
#include "renderer/progressive/progressive_render.h"
#include "renderer/view/view_sampler.h"

namespace foveola::analysis {

/// State of a render after a number of samples.
struct Checkpoint {
  std::uint64_t samples = 0;
  double seconds = 0.0;       ///< time of sampling, tracing and accumulating
  std::vector<Score> scores;  ///< one per region
};

/// One progressive render from its first sample to its last.
struct RenderLog {
  std::uint32_t seed = 0;
  std::uint64_t dropped = 0;  ///< samples that were not finite
  std::vector<Checkpoint> checkpoints;
};

/// One render of each configuration, all with the same seed.
using Repetition = std::vector<RenderLog>;

/// All measurements at one gaze in one scene.
struct GazeMeasurement {
  std::string scene;
  std::string scene_sha256;                 ///< of Subject::key
  std::string gaze;                         ///< "azimuth,elevation", as gaze_name() writes it
  std::vector<std::string> configurations;  ///< the first is the baseline
  std::vector<std::string> regions;
  /// By configuration and region: speed-up predicted from density alone, if any.
  std::vector<std::vector<std::optional<double>>> predicted;
  std::vector<Repetition> repetitions;
};

/// Called with the current activity and the fraction done.
using ReportProgress = std::function<void(const std::string& what, double fraction)>;

/// One gaze of a subject, ready to be measured.
class GazeBench {
 public:
  /// Renders the reference, or takes it from `cache`. Refers to all its arguments. Throws Error as
  /// reference_image.
  GazeBench(const Subject& subject, const ConvergencePlan& plan, const AzimuthElevation& gaze,
            const Workers& workers, const std::filesystem::path& cache,
            const ReportProgress& progress, std::stop_token stop);

  /// Measures the plan's minimum number of repetitions and as many of the others as will probably
  /// end within limit_s (0: no limit). When stopped, returns the finished ones. Configurations
  /// alternate after every few samples, so that a busy machine slows all of them. Computing errors
  /// and the reference is not timed.
  GazeMeasurement measure(double limit_s, const ReportProgress& progress) const;

  /// Returns the display around the gaze after the plan's crop_seconds: a linear image of each
  /// configuration, from left to right, and of the reference.
  RgbImage crops() const;

 private:
  GazeMeasurement without_repetitions() const;
  /// Empty when stopped.
  std::optional<Repetition> run_repetition(std::uint32_t seed,
                                           const std::function<void(double)>& progress) const;
  std::vector<std::vector<std::optional<double>>> predictions() const;

  const Subject* subject_;
  const ConvergencePlan* plan_;
  const Workers* workers_;
  std::stop_token stop_;
  std::string gaze_;
  Aim aim_;
  std::vector<Region> regions_;
  Scorer scorer_;
};

/// Returns the factor by which `method` needs fewer samples than `baseline` for the same mean
/// squared error in a region of a film of `size`, if all of its pixels are equally noisy and noise
/// falls with their samples. With p the probability that a sample falls into a pixel of weight w,
/// it is (sum of w / p of the baseline) / (sum of w / p of the method). Both have the same aim.
/// Empty if either never reaches some pixel.
std::optional<double> predicted_speed_up(const ViewSampler& method, const ViewSampler& baseline,
                                         const PixelRegion& region, const IVec2& size);

/// Renders progressively at one gaze, with the head facing it. Refers to its subject, which must
/// have a tracer for the configuration, and to the workers; both must outlive it.
class ProgressiveRun {
 public:
  ProgressiveRun(const Subject& subject, const ConvergencePlan& plan,
                 const Configuration& configuration, const Aim& aim, std::uint32_t seed,
                 const Workers& workers);

  /// Takes this many more samples.
  void advance(std::uint64_t samples);

  /// Number of samples; those left out by adaptive sampling count.
  std::uint64_t samples() const { return render_.points_drawn(); }
  /// Total time of advance().
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
