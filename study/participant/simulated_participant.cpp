#include "study/participant/simulated_participant.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/base/transformed.h"
#include "renderer/film/viewport_resampler.h"
#include "renderer/image/tone_mapping.h"
#include "study/participant/answers.h"
#include "study/participant/chance.h"

namespace foveola::study {
SimulatedParticipant::SimulatedParticipant(const Population& population, SceneKnowledge knowledge,
                                           std::uint64_t seed)
    : population_(population),
      knowledge_(std::move(knowledge)),
      seed_(seed),
      traits_(draw_traits(population, seed)),
      decision_(population.decision, traits_, seed),
      path_(population.gaze, seed) {}

std::vector<Answer> SimulatedParticipant::answer(const std::string& form,
                                                 const std::vector<Question>& questions) {
  Pcg32 random = chance(seed_, Chance::answers, {key_of(form)});
  return draw_answers(questions, population_.background, random);
}

Nanoseconds SimulatedParticipant::react(std::uint32_t attempt) {
  Pcg32 random = chance(seed_, Chance::reactions, {attempt});
  return draw_reaction(population_.decision, traits_, random);
}

std::size_t SimulatedParticipant::choose_object(const std::string& scene,
                                                const std::vector<OfferedObject>& offered) {
  Pcg32 random = chance(seed_, Chance::choices, {key_of(scene)});
  return random.below(static_cast<std::uint32_t>(offered.size()));
}

void SimulatedParticipant::begin_attempt(const Attempt& attempt) {
  attempt_ = attempt;
  decision_.begin_attempt(attempt);
  path_ = ScanPath(population_.gaze, seed_ ^ std::uint64_t{attempt.conduct} << 32U);
  task_.reset();
  artifact_powers_ = 0.0;
  looks_ = 0;
}

void SimulatedParticipant::turn_to(const std::string& scene, const OfferedObject& object,
                                   Nanoseconds now) {
  scene_ = knowledge_(scene);
  object_ = object;
  area_.reset();
  path_.examine(object_.direction, object_.radius_deg, now);
}

void SimulatedParticipant::begin(Task task, Nanoseconds now) {
  task_ = task;
  decision_.begin(task, now);
  if (task == Task::look_around) {
    path_.explore(azimuth_elevation(object_.direction).azimuth_rad, now);
  } else {
    path_.examine(object_.direction, object_.radius_deg, now);
  }
}

std::optional<Nanoseconds> SimulatedParticipant::see(const Stimulus& stimulus) {
  return judges(stimulus.presented) ? consider(look(stimulus), stimulus.presented) : std::nullopt;
}

std::optional<Nanoseconds> SimulatedParticipant::consider(const Evidence& evidence,
                                                          Nanoseconds now) {
  if (!judges(now)) {
    return std::nullopt;
  }
  if (*task_ == Task::look_around) {
    if (std::isfinite(evidence.artifacts_jnd)) {  // not for a look beyond the view
      artifact_powers_ += std::pow(evidence.artifacts_jnd, population_.rating.pooling_exponent);
      ++looks_;
    }
    return std::nullopt;
  }
  const std::optional<Nanoseconds> press = decision_.consider(evidence, now);
  if (press) {
    task_.reset();
  }
  return press;
}

bool SimulatedParticipant::judges(Nanoseconds now) {
  const auto is_suppressed = [&] {
    return now <
           path_.fixation(now).landing + nanoseconds_from_seconds(population_.gaze.suppression_s);
  };
  return task_ && (*task_ != Task::look_around || !is_suppressed());
}

std::vector<Answer> SimulatedParticipant::rate(const std::vector<Question>& ratings) {
  task_.reset();
  Pcg32 random = chance(seed_, Chance::ratings, {attempt_.conduct});
  const double noticed = noticed_jnd(random);
  std::vector<Answer> answers = draw_answers(ratings, population_.background, random);
  for (Answer& answer : answers) {
    const auto asked = std::ranges::find_if(
        ratings, [&](const Question& question) { return question.id == answer.question; });
    if (is_judged(*asked)) {
      answer.value = study::rate(population_.rating, *asked, noticed);
    }
  }
  return answers;
}

double SimulatedParticipant::noticed_jnd(Pcg32& random) const {
  const double pooled =
      looks_ > 0 ? std::pow(artifact_powers_ / looks_, 1.0 / population_.rating.pooling_exponent)
                 : 0.0;
  return pooled * traits_.rating_bias * std::exp(population_.rating.noise_spread * random.normal());
}

std::vector<SimulatedParticipant::Scale> SimulatedParticipant::make_scales(
    const Vec3& looked_at) const {
  const Vision& vision = population_.vision;
  // An outline is judged on one scale; the material and artifacts on several.
  std::vector<Cells> cells_of_scales;
  switch (*task_) {
    case Task::mark_outline:
      cells_of_scales.push_back(outline_cells(vision, looked_at, object_.radius_deg));
      break;
    case Task::mark_material:
      cells_of_scales = material_cells(vision, looked_at, object_.radius_deg);
      break;
    case Task::look_around:
      cells_of_scales = glance_cells(vision, looked_at);
      break;
  }
  std::vector<Scale> scales;
  for (Cells& cells : cells_of_scales) {
    const Visibility visibility(vision, cells.cell_deg());
    scales.push_back({.cells = std::move(cells), .visibility = visibility});
  }
  return scales;
}

Evidence SimulatedParticipant::look(const Stimulus& stimulus) {
  const Area& area = expect(stimulus);
  switch (*task_) {
    case Task::mark_outline:
      return {.outline_signal_to_noise = outline_signal_to_noise(
                  energies(stimulus, area.scales.front(), true), area.scales.front().visibility,
                  stimulus.gaze, population_.decision.outline_signal_to_noise)};
    case Task::mark_material:
      return {.material_jnd = difference_jnd(stimulus, area)};
    case Task::look_around:
      break;
  }
  return {.artifacts_jnd = difference_jnd(stimulus, area)};
}

double SimulatedParticipant::difference_jnd(const Stimulus& stimulus, const Area& area) const {
  const std::vector<double> of_scales = transformed(area.scales, [&](const Scale& scale) {
    return visible_difference_jnd(energies(stimulus, scale, false), scale.visibility,
                                  stimulus.gaze);
  });
  return pooled_jnd(population_.vision, of_scales);
}

std::vector<PatchEnergies> SimulatedParticipant::energies(const Stimulus& stimulus,
                                                          const Scale& scale,
                                                          bool with_contrast) const {
  return patch_energies(scale.cells, scale.pixels,
                        cell_means(stimulus.image, scale.pixels, population_.vision.jnd_lab),
                        {scale.expected, scale.expected}, with_contrast);
}

const SimulatedParticipant::Area& SimulatedParticipant::expect(const Stimulus& stimulus) {
  const Vec3 looked_at = *task_ == Task::look_around ? stimulus.gaze : object_.direction;
  if (!area_ || area_->task != *task_ || area_->looked_at != looked_at) {
    area_ = Area{.task = *task_,
                 .looked_at = looked_at,
                 .view = std::nullopt,
                 .scales = make_scales(looked_at)};
  }
  if (area_->view != stimulus.viewport) {
    const int width = stimulus.image.width;
    const int height = stimulus.image.height;
    const RgbImage image = display_image(
        viewport_image(*scene_.panorama, stimulus.viewport, width, height), scene_.exposure_stops);
    for (Scale& scale : area_->scales) {
      scale.pixels = pixels_of(scale.cells, stimulus.viewport, width, height);
      scale.expected = cell_means(image, scale.pixels, population_.vision.jnd_lab);
    }
    area_->view = stimulus.viewport;
  }
  return *area_;
}

}  // namespace foveola::study
