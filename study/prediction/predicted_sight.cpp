#include "study/prediction/predicted_sight.h"

#include <algorithm>
#include <array>

namespace foveola::study {
namespace {

/// A look is made again once there are so many times more samples.
constexpr double noticeable_growth = 1.01;

}  // namespace

PatchSamples::PatchSamples(const NoiseTable& table, const ViewSampler& sampler)
    : table_(table), sampler_(sampler), settled_(table.size()), sums_(table.size()) {}

void PatchSamples::settle() {
  if (pending_ > 0.0) {
    const std::vector<double>& per_sample = rates();
    for (std::size_t i = 0; i < settled_.size(); ++i) {
      settled_[i] += pending_ * per_sample[i];
    }
    pending_ = 0.0;
  }
  rates_.clear();
}

std::span<const double> PatchSamples::per_sr() {
  const std::vector<double>& per_sample = rates();
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    sums_[i] = settled_[i] + pending_ * per_sample[i];
  }
  return sums_;
}

const std::vector<double>& PatchSamples::rates() {
  if (rates_.empty()) {
    for (const PatchNoise& patch : table_) {
      rates_.push_back(sampler_.density_per_sr(patch.direction));
    }
  }
  return rates_;
}

PredictedSight::PredictedSight(const PredictedTrial& trial, ViewSampler& sampler, const Aim& facing)
    : trial_(trial),
      sampler_(sampler),
      aim_(facing),
      facing_(facing),
      outline_(trial.object.outline, sampler),
      material_(trial.object.material, sampler),
      around_(trial.around, sampler),
      outline_patches_(energies_without_noise(trial.object.outline)),
      material_patches_(energies_without_noise(trial.object.material)) {
  sampler_.aim(aim_);
}

void PredictedSight::add(double samples, const Aim& aim_now) {
  aim(aim_now);
  samples_ += samples;
  if (is_looking_around_) {
    around_.add(samples);
  } else {
    outline_.add(samples);
    material_.add(samples);
  }
}

void PredictedSight::aim(const Aim& aim) {
  const bool has_moved =
      aim.viewport != aim_.viewport || (trial_.follows_gaze && aim.gaze != aim_.gaze);
  if (!has_moved) {
    return;
  }
  if (is_looking_around_) {
    around_.settle();
  } else {
    outline_.settle();
    material_.settle();
  }
  aim_ = aim;
  sampler_.aim(aim_);
}

Sighting PredictedSight::look(Task task, const Vec3& gaze, const Viewport& viewport) {
  if (task == Task::look_around) {
    return look_around(gaze, viewport);
  }
  if (task == last_look_.task && gaze == last_look_.gaze &&
      samples_ < noticeable_growth * last_look_.samples) {
    return last_look_.sighting;
  }
  Sighting sighting;
  if (task == Task::mark_outline) {
    set_noise(trial_.object.outline, outline_.per_sr(), outline_patches_);
    sighting.outline_signal_to_noise = outline_signal_to_noise(
        outline_patches_, trial_.outline_visibility, gaze, trial_.outline_signal_to_noise);
  } else {
    set_noise(trial_.object.material, material_.per_sr(), material_patches_);
    sighting.material_jnd =
        visible_difference_jnd(material_patches_, trial_.material_visibility, gaze);
  }
  last_look_ = {.task = task, .gaze = gaze, .samples = samples_, .sighting = sighting};
  return sighting;
}

void PredictedSight::begin_looking_around() {
  is_looking_around_ = true;
  sampler_.aim(facing_);
  around_.add(samples_);
  around_.settle();
  sampler_.aim(aim_);
}

Sighting PredictedSight::look_around(const Vec3& gaze, const Viewport& viewport) {
  if (!is_looking_around_) {
    begin_looking_around();
  }
  const std::span<const double> per_sr = around_.per_sr();
  patches_in_view_.clear();
  for (std::size_t i = 0; i < trial_.around.size(); ++i) {
    const PatchNoise& patch = trial_.around[i];
    if (viewport.project(patch.direction)) {
      patches_in_view_.push_back({.direction = patch.direction,
                                  .cells = patch.cells,
                                  .noise = noise_at(patch, per_sr[i]),
                                  .contrast = 0.0});
    }
  }
  return {.artifacts_jnd = visible_difference_jnd(patches_in_view_, trial_.view_visibility, gaze)};
}

bool follows_gaze(ViewSampler& sampler, const Aim& aim) {
  const Vec3 right = glm::normalize(glm::cross(aim.gaze, aim.viewport.head() * Vec3(0, 1, 0)));
  constexpr float shift = 0.05F;
  Aim shifted = aim;
  shifted.gaze = glm::normalize(aim.gaze + shift * right);
  const std::array places = {aim.gaze, shifted.gaze, glm::normalize(aim.gaze - shift * right)};
  const auto densities = [&](const Aim& aimed) {
    sampler.aim(aimed);
    std::array<double, places.size()> result{};
    std::transform(places.begin(), places.end(), result.begin(),
                   [&](const Vec3& place) { return sampler.density_per_sr(place); });
    return result;
  };
  return densities(aim) != densities(shifted);
}

}  // namespace foveola::study
