// Predicts an attempt's film without rendering it: the samples of each patch, and their noise.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "study/participant/participant.h"
#include "study/prediction/noise_atlas.h"

namespace foveola::study {

/// Accumulates the sample densities of a table's patches, for a sampler that is aimed repeatedly.
class PatchSamples {
 public:
  /// Both must outlive this.
  PatchSamples(const NoiseTable& table, const ViewSampler& sampler);

  void add(double samples) { pending_ += samples; }
  /// Call before or after the sampler is aimed elsewhere: earlier samples were taken with the old
  /// aim.
  void settle();
  /// Returns the samples per steradian of each patch.
  std::span<const double> per_sr();

 private:
  const std::vector<double>& rates();

  const NoiseTable& table_;
  const ViewSampler& sampler_;
  std::vector<double> settled_;
  std::vector<double> rates_;  ///< per sample, of the present aim; empty until needed
  std::vector<double> sums_;
  double pending_ = 0.0;
};

/// Accumulates the sample densities of one place after another, for a sampler that is aimed
/// repeatedly.
class SamplesByAim {
 public:
  /// Changes the sampler's aim; it must outlive this.
  explicit SamplesByAim(ViewSampler& sampler) : sampler_(sampler) {}

  void add(double samples, const Aim& aim);
  /// Returns the samples per steradian at `direction`.
  double per_sr(const Vec3& direction);

 private:
  struct Aimed {
    Aim aim;
    double samples = 0.0;
  };
  double per_sr(const Aimed& aimed, const Vec3& direction);

  ViewSampler& sampler_;
  std::vector<Aimed> aimed_;
  Vec3 direction_{0.0F};      ///< Place of the last query:
  std::size_t settled_ = 0;   ///< number of aimed_ that get no more samples,
  double settled_sum_ = 0.0;  ///< and their samples per steradian there.
};

/// Inputs of a prediction, without the sampler and its picture of the object; it refers to them.
struct PredictedTrial {
  const Vision& vision;
  const std::vector<NoiseTable>& surround;
  const Visibility& outline_visibility;
  const std::vector<Visibility>& material_visibilities;  ///< of the material, one per scale
  const std::vector<Visibility>& view_visibilities;
  double outline_signal_to_noise = 5.0;  ///< see outline_signal_to_noise()
  bool follows_gaze = true;  ///< whether the sampler samples elsewhere when only the gaze moves
};

/// One attempt's film, predicted without rendering.
class PredictedFilm {
 public:
  /// facing: the head faces the object while marks are made, with the gaze near it. picture: of the
  /// trial's object. trial, picture and sampler must outlive this.
  PredictedFilm(const PredictedTrial& trial, const ObjectNoise& picture, ViewSampler& sampler,
                const Aim& facing);

  /// Adds samples taken with the aim `aim`.
  void add(double samples, const Aim& aim);

  /// Returns the evidence of a look at the film for `task`.
  Evidence look(Task task, const Vec3& gaze);

 private:
  /// The patches of one scale, as far as they are rendered.
  struct Judged {
    Judged(const NoiseTable& table, const ViewSampler& sampler);
    /// Returns their present energies.
    std::span<const PatchEnergies> seen();

    const NoiseTable& table;
    PatchSamples samples;
    std::vector<PatchEnergies> patches;
  };
  /// A cached look, reused while hardly anything changed.
  struct Look {
    Task task = Task::mark_outline;
    Vec3 gaze{0.0F};
    double samples = -1.0;
    Evidence evidence;
  };

  void aim(const Aim& aim);
  /// Adds the periphery's samples of the marking phase, as if the gaze had stayed at the object's
  /// centre: there a wandering gaze makes little difference.
  void begin_looking_around();
  double material_jnd(const Vec3& gaze);
  double artifacts_jnd(const Vec3& gaze);

  const PredictedTrial& trial_;
  ViewSampler& sampler_;
  Aim aim_;
  const Aim facing_;
  Judged outline_;
  std::vector<Judged> material_;
  std::optional<SamplesByAim> around_;  ///< set once looking around begins
  std::vector<double> jnd_of_scales_;
  double samples_ = 0.0;
  Look last_look_;
};

}  // namespace foveola::study
