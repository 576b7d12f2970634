// Measuring: repetitions of progressive renders, in turns, and their errors on the way.
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

/// A render's state when it had taken some number of samples.
struct Checkpoint {
  std::uint64_t samples = 0;
  double seconds = 0.0;       ///< time of sampling, tracing and filming
  std::vector<Score> scores;  ///< one a region
};

/// One progressive render from its first sample to its last.
struct RenderLog {
  std::uint32_t seed = 0;
  std::uint64_t dropped = 0;  ///< samples that were not finite
  std::vector<Checkpoint> checkpoints;
};

/// One render of each configuration, all with the same seed.
using Repetition = std::vector<RenderLog>;

/// Everything that was measured at one gaze in one scene.
struct GazeMeasurement {
  std::string scene;
  std::string scene_sha256;                 ///< of Subject::key
  std::string gaze;                         ///< "azimuth,elevation", as gaze_name() writes it
  std::vector<std::string> configurations;  ///< the first is the baseline
  std::vector<std::string> regions;
  /// By configuration and region: what density alone predicts of the speed-up, if it does.
  std::vector<std::vector<std::optional<double>>> predicted;
  std::vector<Repetition> repetitions;
};

/// Called with what is being done and the fraction of it that is done.
using ReportProgress = std::function<void(const std::string& what, double fraction)>;

/// One gaze of a subject, ready to be measured.
class GazeBench {
 public:
  /// Renders the reference, or takes it from `cache`. Refers to all that it is given. Throws Error
  /// as reference_image.
  GazeBench(const Subject& subject, const ConvergencePlan& plan, const AzimuthElevation& gaze,
            const Workers& workers, const std::filesystem::path& cache,
            const ReportProgress& progress, std::stop_token stop);

  /// The plan's least number of repetitions and as many of the others as will probably end within
  /// limit_s (0: no limit); those that were finished when stopped. The configurations
  /// take turns after every few samples, so that a busy machine slows all of them; neither
  /// measuring errors nor the reference counts as their time.
  GazeMeasurement measure(double limit_s, const ReportProgress& progress) const;

  /// What the display shows around the gaze after the plan's crop_seconds: a linear image of each
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

/// How many times fewer samples `method` needs than `baseline` for the same mean squared error in a
/// region of a film of `size`, if all of its pixels are equally noisy and noise falls with their
/// samples: with p the probability that a sample falls into a pixel of weight w,
/// (sum of w / p of the baseline) / (sum of w / p of the method). Both are aimed alike. Empty where
/// one of them never reaches some pixel.
std::optional<double> predicted_speed_up(const ViewSampler& method, const ViewSampler& baseline,
                                         const PixelRegion& region, const IVec2& size);

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
