// The film of a predicted attempt, which is not rendered: the samples that each patch has got, and
// the noise that so many leave.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "study/participant/participant.h"
#include "study/prediction/noise_atlas.h"

namespace foveola::study {

/// How densely the patches of a table were sampled, by a sampler that is aimed again and again.
class PatchSamples {
 public:
  /// Both must outlive this.
  PatchSamples(const NoiseTable& table, const ViewSampler& sampler);

  void add(double samples) { pending_ += samples; }
  /// The sampler is about to be aimed elsewhere, or was: what was added before went where it was
  /// aimed then.
  void settle();
  /// Samples per steradian of each patch.
  std::span<const double> per_sr();

 private:
  const std::vector<double>& rates();

  const NoiseTable& table_;
  const ViewSampler& sampler_;
  std::vector<double> settled_;
  std::vector<double> rates_;  ///< per sample, of the present aim; empty until they are needed
  std::vector<double> sums_;
  double pending_ = 0.0;
};

/// How densely a sampler that is aimed again and again sampled one place after another.
class SamplesByAim {
 public:
  /// Aims the sampler, which must outlive this, as it likes.
  explicit SamplesByAim(ViewSampler& sampler) : sampler_(sampler) {}

  void add(double samples, const Aim& aim);
  /// Samples per steradian at `direction`.
  double per_sr(const Vec3& direction);

 private:
  struct Aimed {
    Aim aim;
    double samples = 0.0;
  };
  double per_sr(const Aimed& aimed, const Vec3& direction);

  ViewSampler& sampler_;
  std::vector<Aimed> aimed_;
  Vec3 direction_{0.0F};      ///< Where it was last asked for:
  std::size_t settled_ = 0;   ///< so many of aimed_, which get no more samples,
  double settled_sum_ = 0.0;  ///< have so many samples per steradian there.
};

/// What one trial is predicted with, but for the sampler and its picture of the object; it refers
/// to all of it.
struct PredictedTrial {
  const Vision& vision;
  const std::vector<NoiseTable>& surround;
  const Visibility& outline_visibility;
  const std::vector<Visibility>&
      material_visibilities;  ///< visibilities of the material on each scale
  const std::vector<Visibility>& view_visibilities;
  double outline_signal_to_noise = 5.0;  ///< see outline_signal_to_noise()
  bool follows_gaze = true;  ///< whether the sampler goes elsewhere when only the gaze moves
};

/// One attempt's film, as far as it is known without rendering it.
class PredictedFilm {
 public:
  /// facing: while marks are made, the head faces the object and the gaze is near it. picture: of
  /// the trial's object. trial, picture and sampler must outlive this.
  PredictedFilm(const PredictedTrial& trial, const ObjectNoise& picture, ViewSampler& sampler,
                const Aim& facing);

  /// So many samples go where `aim` says.
  void add(double samples, const Aim& aim);

  /// What a look at the film shows of what `task` asks for.
  Evidence look(Task task, const Vec3& gaze);

 private:
  /// What is judged on one scale, as far as it is rendered.
  struct Judged {
    Judged(const NoiseTable& table, const ViewSampler& sampler);
    /// What there is to see in it now.
    std::span<const PatchEnergies> seen();

    const NoiseTable& table;
    PatchSamples samples;
    std::vector<PatchEnergies> patches;
  };
  /// A look that need not be made again while hardly anything changed.
  struct Look {
    Task task = Task::mark_outline;
    Vec3 gaze{0.0F};
    double samples = -1.0;
    Evidence evidence;
  };

  void aim(const Aim& aim);
  /// What went to the periphery while marks were made, all of it as if the gaze had stayed in the
  /// object's middle: there a wandering gaze makes little difference.
  void begin_looking_around();
  double material_jnd(const Vec3& gaze);
  double artifacts_jnd(const Vec3& gaze);

  const PredictedTrial& trial_;
  ViewSampler& sampler_;
  Aim aim_;
  const Aim facing_;
  Judged outline_;
  std::vector<Judged> material_;
  std::optional<SamplesByAim> around_;  ///< once it is looked around
  std::vector<double> jnd_of_scales_;
  double samples_ = 0.0;
  Look last_look_;
};

}  // namespace foveola::study
