#include "renderer/trace/lights/lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/turns.h"
#include "renderer/trace/materials/opaque_layers.h"

namespace foveola {
namespace {

/// One of this many outcomes is kept out of the learning, to judge it.
constexpr std::size_t outcomes_per_judge = 8;

/// Maximum relative mean square of light samples for using the learned probabilities: they cost a
/// few percent of the time, and lights are not the only source of noise.
constexpr double worth_learning = 0.8;

constexpr float infinitely_far = std::numeric_limits<float>::infinity();

std::optional<LightSample> some_light(const LightSample& sample) {
  return sample.pdf != 0.0F ? std::optional(sample) : std::nullopt;
}

/// The area of the disc that the scene's bounding sphere covers.
double cross_section(const Scene& scene) {
  const Bounds bounds = scene.bounds();
  const double radius = 0.5 * glm::length(DVec3(bounds.upper) - DVec3(bounds.lower));
  return std::numbers::pi * radius * radius;
}

}  // namespace

Lights::Lights(const Scene& scene, const LightSampling& sampling, std::size_t max_in_table)
    : suns_(scene, sampling.selection), local_(scene, sampling, max_in_table), learned_({}) {
  if (scene.environment) {
    environment_.emplace(*scene.environment);
    if (!(environment_->total_luminance() > 0.0)) {
      environment_.reset();
    }
  }
  empty_ = !environment_ && suns_.empty() && local_.empty() && !local_.has_unlisted();
  draws_bright_sky_ = environment_ && !sampling.environment_by_cosine;
  learned_ = LearnedLights(default_probabilities(scene, sampling.selection));
}

KindProbabilities Lights::default_probabilities(const Scene& scene,
                                                LightSelection selection) const {
  struct Source {
    std::size_t lights;
    double power;
    float* probability;
  };
  KindProbabilities probabilities;
  const double area = cross_section(scene);
  const std::array<Source, 3> sources{
      {{environment_ ? 1U : 0U, environment_ ? area * environment_->total_luminance() : 0.0,
        &probabilities.environment},
       {suns_.size(), area * suns_.irradiance(), &probabilities.suns},
       {local_.size(), local_.power(), &probabilities.local}}};
  double kinds = 0.0;
  double lights = 0.0;
  double power = 0.0;
  for (const Source& source : sources) {
    if (source.lights > 0) {
      kinds += 1.0;
      lights += static_cast<double>(source.lights);
      power += source.power;
    }
  }
  const bool is_power_known = power > 0.0 && std::isfinite(power);
  for (const Source& source : sources) {
    if (source.lights == 0) {
      continue;
    }
    const double share = is_power_known ? source.power / power : 1.0 / kinds;
    *source.probability = static_cast<float>(selection == LightSelection::uniform
                                                 ? static_cast<double>(source.lights) / lights
                                                 : 0.5 / kinds + 0.5 * share);
  }
  return probabilities;
}

LightKind Lights::kind_of(const ShadingPoint& shading_point, float u_kind) const {
  const KindProbabilities& probabilities = learned_.kinds(shading_point.region);
  // Rounding may leave a u_kind above the sum, which belongs to the last present kind.
  const bool only_distant = local_.empty();
  if (environment_ && (u_kind < probabilities.environment || (only_distant && suns_.empty()))) {
    return LightKind::environment;
  }
  if (!suns_.empty() && (u_kind < probabilities.environment + probabilities.suns || only_distant)) {
    return LightKind::suns;
  }
  return only_distant ? LightKind::nothing : LightKind::local;
}

std::optional<LightSample> Lights::sample(const ShadingPoint& shading_point, float u_kind,
                                          const Vec2& u_choice, const Vec2& u) const {
  switch (kind_of(shading_point, u_kind)) {
    case LightKind::environment: {
      const EnvironmentLight::Sample sky = sample_sky(shading_point, u);
      return sample_distant(shading_point, sky.direction, sky.light, {});
    }
    case LightKind::suns:
      return sample_suns(shading_point, u_choice, u);
    case LightKind::local:
      if (const auto sample = local_.sample(shading_point, u_choice, u,
                                            learned_.preferences(shading_point.region))) {
        return some_light(from_local(*sample, learned_.kinds(shading_point.region).local));
      }
      break;
    case LightKind::nothing:
      break;
  }
  return std::nullopt;
}

LightOutcome Lights::outcome(const ShadingPoint& shading_point, float u_kind, const Vec2& u_choice,
                             const Vec2& u) const {
  LightOutcome outcome{.shading_point = shading_point,
                       .kind = kind_of(shading_point, u_kind),
                       .light = LightOutcome::no_light};
  if (outcome.kind == LightKind::environment) {
    outcome.light = static_cast<std::uint32_t>(SquareWarp::square_of(u));
  } else if (outcome.kind == LightKind::local) {
    if (const auto chosen = local_.light_drawn(shading_point, u_choice)) {
      outcome.light = static_cast<std::uint32_t>(chosen->light);
    }
  }
  return outcome;
}

void Lights::learn(std::span<const LightOutcome> outcomes) {
  std::vector<LightOutcome> to_learn_from;
  std::vector<LightOutcome> to_judge_by;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    (i % outcomes_per_judge == 0 ? to_judge_by : to_learn_from).push_back(outcomes[i]);
  }
  const KindProbabilities usual = learned_.kinds(0);
  LearnedLights learned(to_learn_from, usual, local_.tree(), draws_bright_sky_);
  if (learned.relative_mean_square(to_judge_by, usual, local_.tree()) < worth_learning) {
    learned_ = std::move(learned);
  }
}

template <typename Number>
LightSampleOf<Number> Lights::from_local(const LocalLightSampleOf<Number>& sample,
                                         const Number& probability) {
  const Number distance = square_root(dot(sample.to_light, sample.to_light));
  return {.direction = sample.to_light / distance,
          .pdf = chosen(distance > 0.0F, probability * sample.pdf, Number{}),
          .radiance = sample.radiance,
          .is_delta = sample.is_delta,
          .to_light = sample.to_light,
          .t_max = Number{} + 1.0F};
}

namespace {

/// Collects samples that were drawn one by one.
class LightSampleLanes {
 public:
  void put(std::size_t lane, const LightSample& sample) {
    direction_.put(lane, sample.direction);
    pdf_[lane] = sample.pdf;
    radiance_.put(lane, sample.radiance);
    is_delta_[lane] = sample.is_delta ? -1 : 0;
    to_light_.put(lane, sample.to_light);
    t_max_[lane] = sample.t_max;
  }
  LightSamples load() const {
    return {.direction = direction_.load(),
            .pdf = pdf_.load(),
            .radiance = radiance_.load(),
            .is_delta = is_delta_,
            .to_light = to_light_.load(),
            .t_max = t_max_.load()};
  }

 private:
  Vec3Lanes direction_{}, radiance_{}, to_light_{};
  FloatLanes pdf_{}, t_max_{};
  LaneMask is_delta_{};
};

/// The first in the lanes of a mask, the second in the others.
LightSamples merged(const LaneMask& mask, const LightSamples& a, const LightSamples& b) {
  return {.direction = chosen(mask, a.direction, b.direction),
          .pdf = chosen(mask, a.pdf, b.pdf),
          .radiance = chosen(mask, a.radiance, b.radiance),
          .is_delta = mask ? a.is_delta : b.is_delta,
          .to_light = chosen(mask, a.to_light, b.to_light),
          .t_max = chosen(mask, a.t_max, b.t_max)};
}

}  // namespace

LightSamples Lights::sample(const ShadingPoints& shading_points, const LightNumbers& numbers,
                            const LaneMask& lanes) const {
  LightSampleLanes one_by_one;
  bool any_one = false;
  const auto put = [&](std::size_t lane, const std::optional<LightSample>& sample) {
    if (sample) {
      one_by_one.put(lane, *sample);
      any_one = true;
    }
  };
  TriangleLights::Drawn drawn = local_.make_batch();
  LaneMask is_drawn{};
  FloatLanes local_probability{};
  for_each_lane(lanes, [&](std::size_t lane) {
    const ShadingPoint shading_point = shading_points.at(lane);
    const Vec2 u_choice = numbers.choice.at(lane);
    const Vec2 u = numbers.point.at(lane);
    if (kind_of(shading_point, numbers.kind[lane]) != LightKind::local) {
      put(lane, sample(shading_point, numbers.kind[lane], u_choice, u));
      return;
    }
    LocalLightSample sampled;
    local_probability[lane] = learned_.kinds(shading_point.region).local;
    switch (local_.choose(shading_point, u_choice, u, learned_.preferences(shading_point.region),
                          lane, drawn, sampled)) {
      case LocalLights::Choice::drawn:
        is_drawn[lane] = -1;
        break;
      case LocalLights::Choice::sampled:
        put(lane, some_light(from_local(sampled, local_probability[lane])));
        break;
      case LocalLights::Choice::nothing:
        break;
    }
  });
  LightSamples samples;
  if (any_one) {
    samples = one_by_one.load();
  }
  if (any_lane(is_drawn)) {
    const LightSamples from_drawn =
        from_local(drawn.sample(shading_points.position.load(), numbers.point.load()),
                   local_probability.load());
    samples = merged(is_drawn & (from_drawn.pdf > 0.0F), from_drawn, samples);
  }
  return samples;
}

std::optional<LightSample> Lights::sample_suns(const ShadingPoint& shading_point,
                                               const Vec2& u_choice, const Vec2& u) const {
  const Suns::Sample sample = suns_.sample(u_choice, u);
  if (!sample.is_delta) {
    return sample_distant(shading_point, sample.direction, sky_at(shading_point, sample.direction),
                          sample.sun);
  }
  return LightSample{.direction = sample.direction,
                     .pdf = learned_.kinds(shading_point.region).suns * sample.probability,
                     .radiance = sample.irradiance,
                     .is_delta = true,
                     .to_light = sample.direction,
                     .t_max = infinitely_far};
}

std::optional<LightSample> Lights::sample_distant(const ShadingPoint& shading_point,
                                                  const Vec3& direction, const DistantLight& sky,
                                                  Sun known) const {
  const DistantLight distant = with_suns(shading_point, sky, direction, known);
  if (!(distant.pdf > 0.0F)) {
    return std::nullopt;
  }
  return LightSample{.direction = direction,
                     .pdf = distant.pdf,
                     .radiance = distant.radiance,
                     .is_delta = false,
                     .to_light = direction,
                     .t_max = infinitely_far};
}

float Lights::triangle_pdf(const ShadingPoint& shading_point, const Hit& hit, float distance,
                           float cosine) const {
  const float probability = learned_.kinds(shading_point.region).local;
  return probability > 0.0F
             ? probability * local_.triangle_pdf(shading_point, hit, distance, cosine,
                                                 learned_.preferences(shading_point.region))
             : 0.0F;
}

DistantLight Lights::with_suns(const ShadingPoint& shading_point, const DistantLight& sky,
                               const Vec3& direction, Sun known) const {
  const KindProbabilities& probabilities = learned_.kinds(shading_point.region);
  const DistantLight both{.radiance = sky.radiance, .pdf = probabilities.environment * sky.pdf};
  if (suns_.empty()) {
    return both;
  }
  const DistantLight suns = suns_.at(direction, known);
  return {.radiance = both.radiance + suns.radiance,
          .pdf = both.pdf + probabilities.suns * suns.pdf};
}

DistantLight Lights::sky_at(const ShadingPoint& shading_point, const Vec3& direction) const {
  if (draws_bright_sky_) {
    DistantLight sky = environment_->at(direction);
    if (const SquareWarp* warp = learned_.sky(shading_point.region)) {
      sky.pdf *= warp->density(environment_->place_of(direction));
    }
    return sky;
  }
  if (!environment_) {
    return {};
  }
  const float cosine = glm::dot(shading_point.normal, direction);
  const float pdf = shading_point.transmits ? 0.5F * std::abs(cosine) : std::max(cosine, 0.0F);
  return {.radiance = environment_->at(direction).radiance,
          .pdf = std::numbers::inv_pi_v<float> * pdf};
}

EnvironmentLight::Sample Lights::sample_sky(const ShadingPoint& shading_point,
                                            const Vec2& u) const {
  if (draws_bright_sky_) {
    const SquareWarp* warp = learned_.sky(shading_point.region);
    if (warp == nullptr) {
      return environment_->sample(u);
    }
    const SquareWarp::Point point = warp->sample(u);
    EnvironmentLight::Sample sample = environment_->sample(point.place);
    sample.light.pdf *= point.density;
    return sample;
  }
  // If light arrives from both sides, half of the numbers go to each.
  const bool is_beyond = shading_point.transmits && u.y < 0.5F;
  const float u_cosine = shading_point.transmits ? std::fmod(2.0F * u.y, 1.0F) : u.y;
  const Vec3 local = sample_cosine_hemisphere(azimuth_at(u.x), u_cosine);
  const Frame frame(is_beyond ? -shading_point.normal : shading_point.normal);
  const Vec3 direction = glm::normalize(frame.to_world(local));
  return {.direction = direction, .light = sky_at(shading_point, direction)};
}

DistantLight Lights::distant_light(const ShadingPoint& shading_point, const Vec3& direction) const {
  return with_suns(shading_point, sky_at(shading_point, direction), direction, {});
}

}  // namespace foveola
