#include "renderer/trace/lights/learned_lights.h"

#include <cmath>
#include <iterator>
#include <numeric>

namespace foveola {
namespace {

/// Light samples per region: few enough for small regions, enough for estimates. Four times as many
/// in all, or per region, did not reduce the noise of built-in scenes.
constexpr std::size_t outcomes_per_region = 64;

/// Weight of the mean over all regions, in draws of a region.
constexpr double prior_draws = 4.0;

/// Share of each choice without learning. With half of it, the variance of the built-in scenes was
/// 3 % less at the camera's place, but other places may lose more.
constexpr double default_part = 0.1;

/// Number of draws of a light, or of a part of the lights, and the sum of their gains.
struct Tally {
  double draws = 0.0;
  double sum = 0.0;

  void add(double value) {
    draws += 1.0;
    sum += value;
  }
  void add(const Tally& other) {
    draws += other.draws;
    sum += other.sum;
  }
  double mean() const { return draws > 0.0 ? sum / draws : 0.0; }
  /// The mean with prior_draws further draws of this mean.
  double mean_with(double prior) const {
    return (sum + prior_draws * prior) / (draws + prior_draws);
  }
};

constexpr std::size_t kind_count = 3;
using KindTallies = std::array<Tally, kind_count>;
using SkyTallies = std::array<Tally, SquareWarp::squares>;
using TreeTallies = std::array<std::array<Tally, LightTree::width>, LightTree::preferring_nodes>;

/// Tallies of a region, or of all.
struct Experience {
  KindTallies kinds;  ///< squared gains
  SkyTallies sky;     ///< squared gains
  TreeTallies tree;   ///< also counts whether anything arrived

  void add(const LightOutcome& outcome, const LightTree* lights) {
    const double squared = static_cast<double>(outcome.gain) * static_cast<double>(outcome.gain);
    kinds[static_cast<std::size_t>(outcome.kind)].add(squared);
    if (outcome.light == LightOutcome::no_light) {
      return;
    }
    if (outcome.kind == LightKind::environment) {
      sky[outcome.light].add(squared);
    } else if (outcome.kind == LightKind::local && lights != nullptr) {
      lights->for_each_preference(outcome.light, [&](std::size_t node, std::size_t child) {
        tree[node][child].add(outcome.gain > 0.0F ? 1.0 : 0.0);
      });
    }
  }
  void add(const Experience& other) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      kinds[i].add(other.kinds[i]);
    }
    for (std::size_t i = 0; i < sky.size(); ++i) {
      sky[i].add(other.sky[i]);
    }
    for (std::size_t node = 0; node < tree.size(); ++node) {
      for (std::size_t child = 0; child < tree[node].size(); ++child) {
        tree[node][child].add(other.tree[node][child]);
      }
    }
  }
};

// The variance of a sum, of which one term is drawn and weighted by 1 / p, is minimal if p is
// proportional to the root mean square of each term.

KindProbabilities kinds_of(const Experience& region, const Experience& all,
                           const KindProbabilities& usual) {
  const std::array<float, kind_count> drawn = {usual.environment, usual.suns, usual.local};
  std::array<double, kind_count> weights{};
  for (std::size_t i = 0; i < kind_count; ++i) {
    weights[i] = drawn[i] * std::sqrt(region.kinds[i].mean_with(all.kinds[i].mean()));
  }
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::array<float, kind_count> probabilities = drawn;
  if (total > 0.0 && std::isfinite(total)) {
    for (std::size_t i = 0; i < kind_count; ++i) {
      probabilities[i] =
          static_cast<float>(default_part * drawn[i] + (1.0 - default_part) * weights[i] / total);
    }
  }
  return {probabilities[0], probabilities[1], probabilities[2]};
}

SquareWarp sky_of(const Experience& region, const Experience& all) {
  std::array<double, SquareWarp::squares> weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = std::sqrt(region.sky[i].mean_with(all.sky[i].mean()));
  }
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const bool is_known = total > 0.0 && std::isfinite(total);
  for (double& weight : weights) {
    const double learned = is_known ? weight / total : 1.0 / SquareWarp::squares;
    weight = default_part / SquareWarp::squares + (1.0 - default_part) * learned;
  }
  return SquareWarp(weights);
}

LightTree::Preferences preferences_of(const Experience& region, const Experience& all) {
  LightTree::Preferences preferences;
  for (std::size_t node = 0; node < preferences.size(); ++node) {
    for (std::size_t child = 0; child < preferences[node].size(); ++child) {
      const double arrived = region.tree[node][child].mean_with(all.tree[node][child].mean());
      preferences[node][child] =
          static_cast<float>(default_part + (1.0 - default_part) * std::sqrt(arrived));
    }
  }
  return preferences;
}

SurfaceRegions regions_of(std::span<const LightOutcome> outcomes) {
  std::vector<SurfaceRegions::Place> places;
  places.reserve(outcomes.size());
  std::transform(outcomes.begin(), outcomes.end(), std::back_inserter(places),
                 [](const LightOutcome& outcome) -> SurfaceRegions::Place {
                   return {outcome.shading_point.position, outcome.shading_point.normal};
                 });
  return SurfaceRegions(std::move(places), outcomes_per_region);
}

}  // namespace

LearnedLights::LearnedLights(std::span<const LightOutcome> outcomes, const KindProbabilities& usual,
                             const LightTree* tree, bool knows_sky)
    : regions_(foveola::regions_of(outcomes)) {
  std::vector<Experience> regions(regions_.count());
  for (const LightOutcome& outcome : outcomes) {
    const ShadingPoint& point = outcome.shading_point;
    regions[region_of(point.position, point.normal)].add(outcome, tree);
  }
  Experience all;
  for (const Experience& region : regions) {
    all.add(region);
  }
  for (const Experience& region : regions) {
    kinds_.push_back(kinds_of(region, all, usual));
    if (knows_sky) {
      sky_.push_back(sky_of(region, all));
    }
    if (tree != nullptr) {
      preferences_.push_back(preferences_of(region, all));
    }
  }
}

double LearnedLights::relative_probability(const LightOutcome& outcome,
                                           const KindProbabilities& usual,
                                           const LightTree* tree) const {
  const ShadingPoint& point = outcome.shading_point;
  const std::uint32_t region = region_of(point.position, point.normal);
  const KindProbabilities& now = kinds(region);
  switch (outcome.kind) {
    case LightKind::environment: {
      const double kind = usual.environment / now.environment;
      return sky_.empty() ? kind : kind / sky_[region].density_in(outcome.light);
    }
    case LightKind::suns:
      return usual.suns / now.suns;
    case LightKind::local: {
      const double kind = usual.local / now.local;
      return tree == nullptr || outcome.light == LightOutcome::no_light
                 ? kind
                 : kind * tree->probability(point, outcome.light) /
                       tree->probability(point, outcome.light, preferences(region));
    }
    case LightKind::nothing:
      break;
  }
  return 1.0;
}

double LearnedLights::relative_mean_square(std::span<const LightOutcome> outcomes,
                                           const KindProbabilities& usual,
                                           const LightTree* tree) const {
  double as_usual = 0.0;
  double as_learned = 0.0;
  for (const LightOutcome& outcome : outcomes) {
    if (outcome.gain > 0.0F) {
      const double squared = static_cast<double>(outcome.gain) * static_cast<double>(outcome.gain);
      as_usual += squared;
      as_learned += squared * relative_probability(outcome, usual, tree);
    }
  }
  return as_usual > 0.0 ? as_learned / as_usual : 1.0;
}

}  // namespace foveola
