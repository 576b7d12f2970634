// Predicts attempts without rendering, for studies whose attempts are all predicted.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/participant/participant.h"
#include "study/prediction/noise_atlas.h"
#include "study/prediction/predicted_film.h"
#include "study/simulation/study_simulation.h"
#include "study/simulation/trial_attempt.h"

namespace foveola::study {

/// Takes the steps of a RenderedAttempt from glance to glance, at the same times. Keeps no frames
/// and no gaze. The tracker's noise, losses and filter are left out, except for the mean delay of
/// losses; its latency and bias are not.
class PredictedAttempt final : public TrialAttempt {
 public:
  /// trial, picture, sampler: see PredictedFilm; without a trial and a picture, the participant
  /// must be one that does not look.
  PredictedAttempt(const TrialAttemptSetting& setting, const PredictedTrial* trial,
                   const ObjectNoise* picture, std::unique_ptr<ViewSampler> sampler);

  void begin(Task task) override { task_ = task; }
  std::uint64_t samples() const override { return samples_until(frames_); }
  std::uint64_t non_finite() const override { return 0; }

 private:
  std::optional<Nanoseconds> show_frames(Nanoseconds until) override;
  std::uint64_t samples_until(std::uint64_t frames) const;
  /// Returns the time, by the attempt's clock, at which the frame of this number, from 0, is on the
  /// display.
  Nanoseconds presented(std::uint64_t frame) const;
  /// Returns the number of the first frame that is presented at `time` or later.
  std::uint64_t frame_at(Nanoseconds time) const;
  /// Adds the frames' samples with the observer's aim at their times.
  void render_until(std::uint64_t frames);
  Evidence look(Nanoseconds now);
  /// Returns the tracker's aim at `time`: delayed by its latency.
  Aim aim(Nanoseconds time) const;
  Viewport viewport(Nanoseconds time) const;

  std::unique_ptr<ViewSampler> sampler_;
  Nanoseconds start_;
  Nanoseconds tracker_delay_;
  std::uint64_t frames_ = 0;
  Task task_ = Task::mark_outline;
  std::optional<PredictedFilm> sight_;
};

/// Returns the pictures that the trials of new and begun sessions will show.
PicturesWanted pictures_wanted(const SimulatedStudy& study, const Vision& vision,
                               const SessionsAhead& ahead);

class PredictedStudy {
 public:
  /// atlas: of `protocol` and `population`, with the pictures_wanted of all sessions, or an empty
  /// one for observers that do not look.
  PredictedStudy(const Protocol& protocol, const SceneStages& stages, const Population& population,
                 NoiseAtlas atlas);
  PredictedStudy(const PredictedStudy&) = delete;
  PredictedStudy& operator=(const PredictedStudy&) = delete;

  /// May be called by several threads at once. This must outlive the attempt.
  std::unique_ptr<TrialAttempt> attempt(const TrialAttemptSetting& setting) const;

 private:
  void add_object(const std::string& scene, const OfferedObject& object,
                  const Population& population);

  const Protocol& protocol_;
  NoiseAtlas atlas_;
  Vision vision_;
  std::vector<Visibility> material_visibilities_;
  std::vector<Visibility> view_visibilities_;
  std::map<double, Visibility> outline_visibilities_;  ///< by cell size
  std::map<PicturedPlace, PredictedTrial> trials_;
};

}  // namespace foveola::study
