// A study whose attempts are all predicted.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "study/prediction/noise_atlas.h"
#include "study/simulation/predicted_attempt.h"
#include "study/simulation/study_simulation.h"

namespace foveola::study {

/// The pictures that the trials of new sessions, and of those that were begun, will be shown.
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

  /// May be called from several threads at once. This must outlive the attempt.
  std::unique_ptr<TrialAttempt> attempt(const TrialAttemptSetting& setting,
                                        SimulatedObserver& observer) const;

 private:
  void add_object(const std::string& scene, const OfferedObject& object,
                  const Population& population);

  const Protocol& protocol_;
  NoiseAtlas atlas_;
  Vision vision_;
  std::vector<Visibility> material_visibilities_;
  std::vector<Visibility> view_visibilities_;
  std::map<double, Visibility> outline_visibilities_;  ///< by the size of cells
  std::map<PicturedPlace, PredictedTrial> trials_;
};

}  // namespace foveola::study
