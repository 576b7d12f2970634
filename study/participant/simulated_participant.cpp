#include "study/participant/simulated_participant.h"

#include <algorithm>
#include <cmath>

#include "renderer/film/viewport_image.h"
#include "renderer/image/tone_mapping.h"
#include "study/participant/answers.h"

namespace foveola::study {
namespace {

// Independent streams of one person's seed.
constexpr std::uint64_t decisions_stream = 1;

/// A factor that is 1 in the median, its logarithm normal with deviation `spread`.
double log_normal_factor(double spread, Pcg32& random) {
  return std::exp(spread * random.normal());
}

}  // namespace

SimulatedParticipant::SimulatedParticipant(const Population& population, SceneKnowledge knowledge,
                                           std::uint64_t seed)
    : observer_(population.observer),
      knowledge_(std::move(knowledge)),
      random_(seed, decisions_stream),
      path_(population.gaze, seed),
      outline_criterion_(observer_.outline_signal_to_noise *
                         log_normal_factor(observer_.criterion_spread, random_)),
      material_criterion_(observer_.material_criterion_jnd *
                          log_normal_factor(observer_.criterion_spread, random_)),
      rating_bias_(log_normal_factor(observer_.criterion_spread, random_)) {}

std::vector<Answer> SimulatedParticipant::answer(const std::vector<Question>& questions) {
  return draw_answers(questions, random_);
}

std::size_t SimulatedParticipant::choose_object(const std::string& scene,
                                                const std::vector<OfferedObject>& offered,
                                                Nanoseconds now) {
  if (!choices_.contains(scene)) {
    choices_[scene] = random_.below(static_cast<std::uint32_t>(offered.size()));
  }
  const std::size_t choice = choices_[scene];
  scene_ = knowledge_(scene);
  object_ = offered[choice];
  expectation_.reset();
  path_.examine(object_.direction, object_.radius_deg, now);
  return choice;
}

void SimulatedParticipant::begin(Task task, Nanoseconds now) {
  task_ = task;
  satisfied_since_.reset();
  if (task == Task::look_around) {
    noticed_jnd_ = 0.0;
    looks_ = 0;
    path_.explore(azimuth_elevation(object_.direction), now);
  } else {
    path_.examine(object_.direction, object_.radius_deg, now);
  }
}

std::optional<Nanoseconds> SimulatedParticipant::see(const Percept& percept) {
  if (!task_) {
    return std::nullopt;
  }
  if (*task_ == Task::look_around) {
    notice_artifacts(percept);
    return std::nullopt;
  }
  const bool satisfied =
      *task_ == Task::mark_outline ? outline_stands_out(percept) : material_is_right(percept);
  if (!satisfied) {
    satisfied_since_.reset();
    return std::nullopt;
  }
  satisfied_since_ = satisfied_since_.value_or(percept.presented);
  if (percept.presented - *satisfied_since_ < nanoseconds_from_seconds(observer_.integration_s)) {
    return std::nullopt;
  }
  task_.reset();
  return percept.presented + nanoseconds_from_seconds(reaction_time_s());
}

int SimulatedParticipant::rate_artifacts() {
  task_.reset();
  const double mean_jnd = looks_ > 0 ? noticed_jnd_ / looks_ : 0.0;
  int rating = 1;
  double threshold_jnd = observer_.rating_2_jnd;
  while (rating < 5 && rating_bias_ * mean_jnd >= threshold_jnd) {
    ++rating;
    threshold_jnd *= observer_.rating_step;
  }
  return rating;
}

const SimulatedParticipant::Expectation& SimulatedParticipant::expect(const Percept& percept) {
  const int width = percept.image.width;
  const int height = percept.image.height;
  const bool current = expectation_ && expectation_->viewport == percept.viewport &&
                       expectation_->image.width == width && expectation_->image.height == height;
  if (!current) {
    expectation_ = Expectation{
        .viewport = percept.viewport,
        .image = display_image(viewport_image(*scene_.panorama, percept.viewport, width, height),
                               scene_.exposure_stops),
        .outline = region_around(percept.viewport, width, height, object_.direction,
                                 object_.radius_deg * observer_.outline_surround,
                                 observer_.outline_patch_deg),
        .material = region_around(percept.viewport, width, height, object_.direction,
                                  object_.radius_deg, observer_.material_patch_deg)};
  }
  return *expectation_;
}

bool SimulatedParticipant::outline_stands_out(const Percept& percept) {
  const Expectation& expected = expect(percept);
  const Eye eye{.gaze = percept.gaze, .half_magnification_deg = observer_.half_magnification_deg};
  const double noise = visible_difference(percept.image, expected.image, expected.outline, eye);
  const double contrast = visible_contrast(expected.image, expected.outline, eye);
  // Where there is hardly anything to see, noise below a just noticeable difference will do.
  return noise * outline_criterion_ <= std::max(contrast, observer_.jnd_srgb * outline_criterion_);
}

bool SimulatedParticipant::material_is_right(const Percept& percept) {
  const Expectation& expected = expect(percept);
  const Eye eye{.gaze = percept.gaze, .half_magnification_deg = observer_.half_magnification_deg};
  const double noise = visible_difference(percept.image, expected.image, expected.material, eye);
  return noise <= material_criterion_ * observer_.jnd_srgb;
}

void SimulatedParticipant::notice_artifacts(const Percept& percept) {
  const Expectation& expected = expect(percept);
  const Region view = whole_view(percept.viewport, percept.image.width, percept.image.height);
  const Eye eye{.gaze = percept.gaze, .half_magnification_deg = observer_.half_magnification_deg};
  noticed_jnd_ += visible_difference(percept.image, expected.image, view, eye) / observer_.jnd_srgb;
  ++looks_;
}

double SimulatedParticipant::reaction_time_s() {
  const double normal_part =
      observer_.reaction_mean_s + observer_.reaction_deviation_s * random_.normal();
  return std::max(0.0, normal_part) + observer_.reaction_tail_s * random_.exponential();
}

}  // namespace foveola::study
