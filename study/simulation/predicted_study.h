// A study whose attempts are all predicted.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "study/prediction/noise_atlas.h"
#include "study/simulation/predicted_attempt.h"

namespace foveola::study {

class PredictedStudy {
 public:
  /// atlas: of `protocol` and `population`, or an empty one for observers that do not look.
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
  std::map<NoiseAtlas::Place, PredictedTrial> trials_;
};

}  // namespace foveola::study
