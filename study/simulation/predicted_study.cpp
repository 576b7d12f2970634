#include "study/simulation/predicted_study.h"

#include "study/prediction/aim_dependence.h"
#include "study/prediction/judged_view.h"

namespace foveola::study {

namespace {

std::vector<Visibility> visibilities(const Vision& vision, double finest_cell_deg) {
  std::vector<Visibility> of_scales;
  for (const double cell_deg : scales_deg(vision, finest_cell_deg)) {
    of_scales.emplace_back(vision, cell_deg);
  }
  return of_scales;
}

}  // namespace

PicturesWanted pictures_wanted(const SimulatedStudy& study, const Vision& vision,
                               const SessionsAhead& ahead) {
  PicturesWanted wanted;
  const auto add = [&](int design_row) {
    const SessionSeed seed{.seed = study.settings.seed, .design_row = design_row};
    const Plan plan = make_plan(study.protocol, seed.seed, design_row);
    const std::unique_ptr<SimulatedObserver> observer =
        study.make_observer(derive_seed(seed, SeedPurpose::participant, {}), design_row, plan);
    for (const PlannedTrial& trial : plan) {
      const std::vector<OfferedObject>& objects = study.stages.at(trial.scene)->objects();
      const std::string& object = objects[observer->choose_object(trial.scene, objects)].name;
      wanted[{trial.scene, trial.method, object}].insert(picture_seed(seed, study.protocol, trial) %
                                                         picture_count(vision));
    }
  };
  for (const KnownSession& session : ahead.begun) {
    add(session.design_row);
  }
  for (const int design_row : ahead.new_rows) {
    add(design_row);
  }
  return wanted;
}

PredictedStudy::PredictedStudy(const Protocol& protocol, const SceneStages& stages,
                               const Population& population, NoiseAtlas atlas)
    : protocol_(protocol),
      atlas_(std::move(atlas)),
      vision_(population.vision),
      material_visibilities_(visibilities(vision_, vision_.material_cell_deg)),
      view_visibilities_(visibilities(vision_, vision_.view_cell_deg)) {
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
    trials_.emplace(
        PicturedPlace{scene, method, object.name},
        PredictedTrial{
            .vision = vision_,
            .surround = atlas_.surround.at(scene),
            .outline_visibility = outline_visibility,
            .material_visibilities = material_visibilities_,
            .view_visibilities = view_visibilities_,
            .outline_signal_to_noise = population.decision.outline_signal_to_noise,
            .follows_gaze = follows_gaze(*sampler, aim_at(object.direction, protocol_.display))});
  }
}

std::unique_ptr<TrialAttempt> PredictedStudy::attempt(const TrialAttemptSetting& setting,
                                                      SimulatedObserver& observer) const {
  auto sampler = make_sampler(protocol_, setting.trial.method);
  if (trials_.empty()) {
    return std::make_unique<PredictedAttempt>(setting, observer, nullptr, nullptr,
                                              std::move(sampler));
  }
  const PicturedPlace place{setting.trial.scene, setting.trial.method, setting.object.name};
  const std::uint32_t number = setting.seeds.picture % picture_count(vision_);
  return std::make_unique<PredictedAttempt>(setting, observer, &trials_.at(place),
                                            &atlas_.objects.at(place).at(number),
                                            std::move(sampler));
}

}  // namespace foveola::study
