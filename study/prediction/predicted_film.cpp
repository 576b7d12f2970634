#include "study/prediction/predicted_film.h"

#include <algorithm>
#include <limits>

namespace foveola::study {
namespace {

/// Growth of the samples after which a look is computed anew.
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

void SamplesByAim::add(double samples, const Aim& aim) {
  const bool is_same = !aimed_.empty() && aimed_.back().aim.viewport == aim.viewport &&
                       aimed_.back().aim.gaze == aim.gaze;
  if (!is_same) {
    aimed_.push_back({.aim = aim, .samples = 0.0});
  }
  aimed_.back().samples += samples;
}

double SamplesByAim::per_sr(const Aimed& aimed, const Vec3& direction) {
  sampler_.aim(aimed.aim);
  return aimed.samples * density_around(sampler_, direction);
}

double SamplesByAim::per_sr(const Vec3& direction) {
  if (direction != direction_) {
    direction_ = direction;
    settled_ = 0;
    settled_sum_ = 0.0;
  }
  for (; settled_ + 1 < aimed_.size(); ++settled_) {
    settled_sum_ += per_sr(aimed_[settled_], direction);
  }
  return settled_sum_ + (aimed_.empty() ? 0.0 : per_sr(aimed_.back(), direction));
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
      outline_(picture.outline, sampler) {
  for (const NoiseTable& table : picture.material) {
    material_.emplace_back(table, sampler);
  }
  sampler_.aim(aim_);
}

void PredictedFilm::add(double samples, const Aim& aim_now) {
  if (around_) {
    around_->add(samples, aim_now);
    return;
  }
  aim(aim_now);
  samples_ += samples;
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
  outline_.samples.settle();
  for (Judged& scale : material_) {
    scale.samples.settle();
  }
  aim_ = aim;
  sampler_.aim(aim_);
}

Evidence PredictedFilm::look(Task task, const Vec3& gaze) {
  if (task == Task::look_around) {
    return {.artifacts_jnd = artifacts_jnd(gaze)};
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
  around_.emplace(sampler_);
  around_->add(samples_, facing_);
}

double PredictedFilm::artifacts_jnd(const Vec3& gaze) {
  if (!around_) {
    begin_looking_around();
  }
  const NoiseTable& places = trial_.surround.front();
  if (places.empty()) {  // a display without enough pixels
    return std::numeric_limits<double>::infinity();
  }
  const auto nearest = std::ranges::max_element(places, [&](const auto& one, const auto& other) {
    return glm::dot(one.direction, gaze) < glm::dot(other.direction, gaze);
  });
  const double per_sr = around_->per_sr(gaze);
  jnd_of_scales_.clear();
  for (std::size_t scale = 0; scale < trial_.surround.size(); ++scale) {
    const PatchNoise& like_here = trial_.surround[scale][nearest - places.begin()];
    const PatchEnergies seen{.direction = gaze,
                             .cells = like_here.cells,
                             .noise = noise_at(like_here, per_sr),
                             .contrast = 0.0};
    jnd_of_scales_.push_back(
        visible_difference_jnd({&seen, 1}, trial_.view_visibilities[scale], gaze));
  }
  return pooled_jnd(trial_.vision, jnd_of_scales_);
}

}  // namespace foveola::study
