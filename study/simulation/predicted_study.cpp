#include "study/simulation/predicted_study.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/transformed.h"
#include "study/prediction/aim_dependence.h"
#include "study/prediction/judged_view.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// Returns the mean delay from the eye to a frame: the tracker's latency, half an interval between
/// its samples, and the mean delay by losses.
Nanoseconds mean_delay(const SimulatedTrackerSettings& tracker) {
  const double lost = std::min(tracker.data_loss, 0.99);
  const double intervals = 0.5 + lost / (1.0 - lost);
  return nanoseconds_from_seconds(tracker.latency_s + intervals / tracker.rate_hz);
}

std::vector<Visibility> visibilities(const Vision& vision, double finest_cell_deg) {
  return transformed(scales_deg(vision, finest_cell_deg),
                     [&](const double cell_deg) { return Visibility(vision, cell_deg); });
}

}  // namespace

PicturesWanted pictures_wanted(const SimulatedStudy& study, const Vision& vision,
                               const SessionsAhead& ahead) {
  PicturesWanted wanted;
  const auto add = [&](int design_row) {
    const SessionSeed seed{.seed = study.settings.seed, .design_row = design_row};
    const Plan plan = make_plan(study.protocol, seed.seed, design_row);
    const std::unique_ptr<Participant> observer =
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

std::unique_ptr<TrialAttempt> PredictedStudy::attempt(const TrialAttemptSetting& setting) const {
  auto sampler = make_sampler(protocol_, setting.trial.method);
  if (trials_.empty()) {
    return std::make_unique<PredictedAttempt>(setting, nullptr, nullptr, std::move(sampler));
  }
  const PicturedPlace place{setting.trial.scene, setting.trial.method, setting.object.name};
  const std::uint32_t number = setting.seeds.picture % picture_count(vision_);
  return std::make_unique<PredictedAttempt>(
      setting, &trials_.at(place), &atlas_.objects.at(place).at(number), std::move(sampler));
}

PredictedAttempt::PredictedAttempt(const TrialAttemptSetting& setting, const PredictedTrial* trial,
                                   const ObjectNoise* picture, std::unique_ptr<ViewSampler> sampler)
    : TrialAttempt(setting),
      sampler_(std::move(sampler)),
      start_(setting.clock.now()),
      tracker_delay_(mean_delay(setting.protocol.tracker.simulated)) {
  if (trial != nullptr) {
    sight_.emplace(*trial, *picture, *sampler_,
                   aim_at(setting.object.direction, setting.protocol.display));
  }
}

std::optional<Nanoseconds> PredictedAttempt::show_frames(Nanoseconds until) {
  const std::uint64_t interval = frames_per_glance(setting_.protocol.machine);
  const std::uint64_t next_glance = (frames_ + interval - 1) / interval * interval;
  const std::uint64_t last = std::max(frames_, frame_at(until));
  if (last < next_glance) {
    render_until(last + 1);
    setting_.clock.advance(presented(last) - setting_.clock.now());
    return std::nullopt;
  }
  render_until(next_glance + 1);
  const Nanoseconds now = presented(next_glance);
  setting_.clock.advance(now - setting_.clock.now());
  return setting_.participant.consider(look(now), now);
}

Evidence PredictedAttempt::look(Nanoseconds now) {
  return sight_ ? sight_->look(task_, setting_.participant.gaze(now)) : Evidence{};
}

std::uint64_t PredictedAttempt::samples_until(std::uint64_t frames) const {
  return samples_after(frames, setting_.protocol.machine, setting_.trial);
}

Nanoseconds PredictedAttempt::presented(std::uint64_t frame) const {
  return start_ + nanoseconds_from_seconds(static_cast<double>(frame + 1) /
                                           setting_.protocol.machine.frame_rate_hz);
}

std::uint64_t PredictedAttempt::frame_at(Nanoseconds time) const {
  const double frames = seconds(time - start_) * setting_.protocol.machine.frame_rate_hz - 1.0;
  auto frame = static_cast<std::uint64_t>(std::max(0.0, std::floor(frames)));
  while (presented(frame) < time) {
    ++frame;
  }
  return frame;
}

void PredictedAttempt::render_until(std::uint64_t frames) {
  if (sight_) {
    const auto samples = static_cast<double>(samples_until(frames) - samples_until(frames_));
    // The frames of one glance are added at once, with the aim at their midpoint.
    const Nanoseconds begin = presented(frames_);
    sight_->add(samples, aim(begin + (presented(frames - 1) - begin) / 2));
  }
  frames_ = frames;
}

Aim PredictedAttempt::aim(Nanoseconds time) const {
  const Viewport view = viewport(time);
  const SimulatedTrackerSettings& tracker = setting_.protocol.tracker.simulated;
  const Nanoseconds seen = std::max(time - tracker_delay_, Nanoseconds(0));
  Vec3 gaze = setting_.participant.gaze(seen);
  const bool changes_gaze =
      tracker.bias_right_deg != 0.0 || tracker.bias_up_deg != 0.0 || setting_.correction;
  if (changes_gaze) {
    AzimuthElevation in_head = azimuth_elevation(glm::conjugate(view.head()) * gaze);
    in_head.azimuth_rad += radians(tracker.bias_right_deg);
    in_head.elevation_rad += radians(tracker.bias_up_deg);
    std::vector<GazeSample> samples = {
        {.time = time, .direction = direction_from(in_head), .valid = true}};
    if (setting_.correction) {
      correct(samples, *setting_.correction);
    }
    gaze = glm::normalize(view.head() * samples.front().direction);
  }
  return {.viewport = view, .gaze = gaze, .pointer = std::nullopt};
}

Viewport PredictedAttempt::viewport(Nanoseconds time) const {
  const DisplaySettings& display = setting_.protocol.display;
  return {head_orientation(setting_.participant.head(time)), radians(display.horizontal_fov_deg),
          radians(display.vertical_fov_deg), display.lens};
}

}  // namespace foveola::study
