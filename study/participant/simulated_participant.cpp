#include "study/participant/simulated_participant.h"

#include <algorithm>
#include <cmath>

#include "renderer/film/viewport_image.h"
#include "renderer/image/tone_mapping.h"
#include "study/participant/answers.h"

namespace foveola::study {
namespace {

/// Independent streams of one person's seed.
enum class Stream : std::uint64_t { traits, answers, choices, reactions, decisions };

Pcg32 stream(std::uint64_t seed, Stream purpose, std::uint32_t key = 0) {
  return Pcg32(seed, static_cast<std::uint64_t>(purpose) | std::uint64_t{key} << 32U);
}

/// A number for a text, the same everywhere.
std::uint32_t key_of(const std::string& text) {
  std::uint32_t key = 0;
  for (const char character : text) {
    key = mix(key, static_cast<unsigned char>(character));
  }
  return key;
}

/// A factor that is 1 in the median, its logarithm normal with deviation `spread`.
double log_normal_factor(double spread, Pcg32& random) {
  return std::exp(spread * random.normal());
}

}  // namespace

SimulatedParticipant::SimulatedParticipant(const Population& population, SceneKnowledge knowledge,
                                           std::uint64_t seed)
    : observer_(population.observer),
      habits_(population.gaze),
      knowledge_(std::move(knowledge)),
      seed_(seed),
      random_(stream(seed, Stream::traits)),
      path_(population.gaze, seed),
      outline_criterion_(observer_.outline_signal_to_noise *
                         log_normal_factor(observer_.criterion_spread, random_)),
      material_criterion_(observer_.material_criterion_jnd *
                          log_normal_factor(observer_.criterion_spread, random_)),
      rating_bias_(log_normal_factor(observer_.criterion_spread, random_)) {}

std::vector<Answer> SimulatedParticipant::answer(const std::string& form,
                                                 const std::vector<Question>& questions) {
  Pcg32 random = stream(seed_, Stream::answers, key_of(form));
  return draw_answers(questions, random);
}

Nanoseconds SimulatedParticipant::react(std::uint32_t occasion) {
  Pcg32 random = stream(seed_, Stream::reactions, occasion);
  return reaction_time(random);
}

std::size_t SimulatedParticipant::choose_object(const std::string& scene,
                                                const std::vector<OfferedObject>& offered) {
  Pcg32 random = stream(seed_, Stream::choices, key_of(scene));
  return random.below(static_cast<std::uint32_t>(offered.size()));
}

void SimulatedParticipant::begin_occasion(std::uint32_t conduct) {
  random_ = stream(seed_, Stream::decisions, conduct);
  path_ = ScanPath(habits_, seed_ ^ std::uint64_t{conduct} << 32U);
  task_.reset();
}

void SimulatedParticipant::turn_to(const std::string& scene, const OfferedObject& object,
                                   Nanoseconds now) {
  scene_ = knowledge_(scene);
  object_ = object;
  expectation_.reset();
  path_.examine(object_.direction, object_.radius_deg, now);
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
  return percept.presented + reaction_time(random_);
}

std::vector<Answer> SimulatedParticipant::rate(const std::vector<Question>& ratings) {
  task_.reset();
  std::vector<Answer> answers = draw_answers(ratings, random_);
  for (Answer& answer : answers) {
    const auto asked = std::find_if(ratings.begin(), ratings.end(), [&](const Question& question) {
      return question.id == answer.question;
    });
    if (asked->id == "artifacts" && asked->kind == QuestionKind::likert) {
      answer.value = judge_artifacts(*asked);
    }
  }
  return answers;
}

double SimulatedParticipant::judge_artifacts(const Question& scale) const {
  const double mean_jnd = looks_ > 0 ? noticed_jnd_ / looks_ : 0.0;
  double rating = scale.minimum;
  double threshold_jnd = observer_.rating_2_jnd;
  while (rating < scale.maximum && rating_bias_ * mean_jnd >= threshold_jnd) {
    rating += 1.0;
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

Nanoseconds SimulatedParticipant::reaction_time(Pcg32& random) const {
  const double normal_part =
      observer_.reaction_mean_s + observer_.reaction_deviation_s * random.normal();
  const double tail = observer_.reaction_tail_s * random.exponential();
  return nanoseconds_from_seconds(std::max(0.0, normal_part) + tail);
}

}  // namespace foveola::study
