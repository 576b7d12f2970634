#include "study/commands/predicted_study.h"

#include "study/prediction/judged_view.h"

namespace foveola::study {

PredictedStudy::PredictedStudy(const Protocol& protocol, const SceneStages& stages,
                               const Population& population, NoiseAtlas atlas)
    : protocol_(protocol),
      atlas_(std::move(atlas)),
      material_visibility_(population.vision, population.vision.material_cell_deg),
      view_visibility_(population.vision, population.vision.view_cell_deg) {
  if (atlas_.objects.empty()) {
    return;
  }
  for (const auto& [scene, stage] : stages) {
    for (const OfferedObject& object : stage->objects()) {
      add_object(scene, object, population);
    }
  }
}

void PredictedStudy::add_object(const std::string& scene, const OfferedObject& object,
                                const Population& population) {
  const double cell_deg =
      outline_cells(population.vision, object.direction, object.radius_deg).cell_deg();
  const Visibility& outline_visibility =
      outline_visibilities_.try_emplace(cell_deg, population.vision, cell_deg).first->second;
  for (const std::string& method : protocol_.methods) {
    const auto sampler = make_sampler(protocol_, method);
    const NoiseAtlas::Place place{scene, method, object.name};
    trials_.emplace(
        place,
        PredictedTrial{
            .object = atlas_.objects.at(place),
            .around = atlas_.around.at(scene),
            .outline_visibility = outline_visibility,
            .material_visibility = material_visibility_,
            .view_visibility = view_visibility_,
            .outline_signal_to_noise = population.decision.outline_signal_to_noise,
            .follows_gaze = follows_gaze(*sampler, aim_at(object.direction, protocol_.display))});
  }
}

std::unique_ptr<TrialAttempt> PredictedStudy::attempt(const TrialAttemptSetting& setting,
                                                      SimulatedObserver& observer) const {
  const auto known = trials_.find({setting.trial.scene, setting.trial.method, setting.object.name});
  return std::make_unique<PredictedAttempt>(setting, observer,
                                            known != trials_.end() ? &known->second : nullptr,
                                            make_sampler(protocol_, setting.trial.method));
}

}  // namespace foveola::study
