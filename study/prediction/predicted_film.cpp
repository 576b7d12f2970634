#include "study/prediction/predicted_film.h"

#include "renderer/view/density_around.h"

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
      rates_.push_back(density_around(sampler_, patch.direction));
    }
  }
  return rates_;
}

PredictedFilm::Judged::Judged(const NoiseTable& judged, const ViewSampler& sampler)
    : table(judged), samples(judged, sampler), patches(energies_without_noise(judged)) {}

std::span<const PatchEnergies> PredictedFilm::Judged::seen() {
  const std::span<const double> per_sr = samples.per_sr();

  for (std::size_t i = 0; i < table.size(); ++i) {
    patches[i].noise = noise_at(table[i], per_sr[i]);
  }
  return patches;
}

PredictedFilm::PredictedFilm(const PredictedTrial& trial, const ObjectNoise& picture,
                             ViewSampler& sampler, const Aim& facing)
    : trial_(trial),
      sampler_(sampler),
      aim_(facing),
      facing_(facing),
      outline_(picture.outline, sampler),
      around_(trial.surround.front(), sampler) {
  for (const NoiseTable& table : picture.material) {
    material_.emplace_back(table, sampler);
  }
  sampler_.aim(aim_);
}

void PredictedFilm::add(double samples, const Aim& aim_now) {
  aim(aim_now);
  samples_ += samples;
  if (is_looking_around_) {
    around_.add(samples);
    return;
  }
  outline_.samples.add(samples);
  for (Judged& scale : material_) {
    scale.samples.add(samples);
  }
}

void PredictedFilm::aim(const Aim& aim) {
  const bool has_moved =
      aim.viewport != aim_.viewport || (trial_.follows_gaze && aim.gaze != aim_.gaze);
  if (!has_moved) {
    return;
  }
  if (is_looking_around_) {
    around_.settle();
  } else {
    outline_.samples.settle();
    for (Judged& scale : material_) {
      scale.samples.settle();
    }
  }
  aim_ = aim;
  sampler_.aim(aim_);
}

Evidence PredictedFilm::look(Task task, const Vec3& gaze, const Viewport& viewport) {
  if (task == Task::look_around) {
    return {.artifacts_jnd = artifacts_jnd(gaze, viewport)};
  }
  if (task == last_look_.task && gaze == last_look_.gaze &&
      samples_ < noticeable_growth * last_look_.samples) {
    return last_look_.evidence;
  }
  Evidence evidence;
  if (task == Task::mark_outline) {
    evidence.outline_signal_to_noise = outline_signal_to_noise(
        outline_.seen(), trial_.outline_visibility, gaze, trial_.outline_signal_to_noise);
  } else {
    evidence.material_jnd = material_jnd(gaze);
  }
  last_look_ = {.task = task, .gaze = gaze, .samples = samples_, .evidence = evidence};
  return evidence;
}

double PredictedFilm::material_jnd(const Vec3& gaze) {
  jnd_of_scales_.clear();
  for (std::size_t scale = 0; scale < material_.size(); ++scale) {
    jnd_of_scales_.push_back(
        visible_difference_jnd(material_[scale].seen(), trial_.material_visibilities[scale], gaze));
  }
  return pooled_jnd(trial_.vision, jnd_of_scales_);
}

void PredictedFilm::begin_looking_around() {
  is_looking_around_ = true;
  sampler_.aim(facing_);
  around_.add(samples_);
  around_.settle();
  sampler_.aim(aim_);
}

void PredictedFilm::find_in_view(const Viewport& viewport) {
  if (viewed_ == viewport) {
    return;
  }
  const NoiseTable& table = trial_.surround.front();
  in_view_.clear();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (viewport.project(table[i].direction)) {
      in_view_.push_back(i);
    }
  }
  viewed_ = viewport;
}

double PredictedFilm::artifacts_jnd(const Vec3& gaze, const Viewport& viewport) {
  if (!is_looking_around_) {
    begin_looking_around();
  }
  find_in_view(viewport);
  const std::span<const double> per_sr = around_.per_sr();
  jnd_of_scales_.clear();
  for (std::size_t scale = 0; scale < trial_.surround.size(); ++scale) {
    const NoiseTable& table = trial_.surround[scale];
    patches_in_view_.clear();
    for (const std::size_t i : in_view_) {
      patches_in_view_.push_back({.direction = table[i].direction,
                                  .cells = table[i].cells,
                                  .noise = noise_at(table[i], per_sr[i]),
                                  .contrast = 0.0});
    }
    jnd_of_scales_.push_back(
        visible_difference_jnd(patches_in_view_, trial_.view_visibilities[scale], gaze));
  }

  return pooled_jnd(trial_.vision, jnd_of_scales_);
}

}  // namespace foveola::study
