#include "renderer/trace/light_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace foveola {
namespace {

constexpr std::uint32_t no_leaf = ~0U;

/// Below this depth lights are halved by number, so that no arrangement of them makes the tree
/// degenerate into a list.
constexpr int deepest_cost_split = 40;

constexpr int most_bins = 12;

/// Cosines of angles are wrong by up to this: a cosine next to 1 that is wrong by 1e-7 stands for
/// an angle that is wrong by 4e-4. Nothing is left out for being turned away by less.
constexpr float slack = 1e-3F;

/// Square metres; keeps what is divided by it finite.
constexpr float smallest_squared_distance = 1e-20F;

struct Angle {
  float cosine;
  float sine;
};

Angle angle_of(float cosine) { return {cosine, std::sqrt(std::max(0.0F, 1.0F - cosine * cosine))}; }

/// max(0, a - b), for angles in [0, pi].
Angle difference(const Angle& a, const Angle& b) {
  if (a.cosine > b.cosine) {
    return {1.0F, 0.0F};
  }
  return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

/// The surface area orientation heuristic of one side of a split: what the lights give times how
/// far they are apart in place and in direction.
double cost_of(const LightBounds& bounds) {
  const double radius = bounds.radius();
  return bounds.intensity * orientation_measure(bounds) * radius * radius;
}

}  // namespace

class LightTree::Builder {
 public:
  Builder(LightTree& tree, std::span<const LightBounds> lights)
      : tree_(tree), lights_(lights), leaf_of_light_(tree.leaf_of_light_) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      if (lights[i].intensity > 0.0) {
        order_.push_back(i);
        total_intensity_ += lights[i].intensity;
      }
    }
  }

  void build() {
    assert(!order_.empty());
    leaf_of_light_.assign(lights_.size(), no_leaf);
    tree_.nodes_.reserve(2 * order_.size());
    tree_.nodes_.resize(2);
    tree_.parent_of_pair_.reserve(order_.size());
    tree_.parent_of_pair_.resize(1);
    build(0, order_, 0);
  }

 private:
  /// Fills node `index` with the lights of `items`, and returns their bounds.
  LightBounds build(std::uint32_t index, std::span<std::uint32_t> items, int depth) {
    if (items.size() == 1) {
      leaf_of_light_[items[0]] = index;
      fill(index, lights_[items[0]], items[0], true);
      return lights_[items[0]];
    }
    const auto middle = static_cast<std::size_t>(split(items, depth) - items.begin());
    const auto children = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.resize(tree_.nodes_.size() + 2);
    tree_.parent_of_pair_.push_back(index);
    const LightBounds left = build(children, items.first(middle), depth + 1);
    const LightBounds right = build(children + 1, items.subspan(middle), depth + 1);
    const LightBounds both = merge(left, right);
    fill(index, both, children, false);
    return both;
  }

  void fill(std::uint32_t index, const LightBounds& bounds, std::uint32_t refers_to, bool is_leaf) {
    const Vec3 centre(bounds.centre());
    const Vec3 furthest = glm::max(glm::abs(bounds.box.lower), glm::abs(bounds.box.upper));
    const double rounding = 4.0 * std::numeric_limits<float>::epsilon() * max_component(furthest);
    const double radius = bounds.radius() * (1.0 + 1e-5) + rounding;
    Node& node = tree_.nodes_[index];
    node.centre = centre;
    node.radius = static_cast<float>(radius);
    node.axis = Vec3(bounds.axis);
    node.spread_cosine = static_cast<float>(std::cos(bounds.spread_rad));
    node.spread_sine = static_cast<float>(std::sin(bounds.spread_rad));
    node.falloff_cosine = static_cast<float>(std::cos(bounds.falloff_rad));
    node.intensity = std::max(static_cast<float>(bounds.intensity / total_intensity_),
                              std::numeric_limits<float>::min());
    node.index = refers_to & ((1U << 30U) - 1U);
    node.is_leaf = is_leaf ? 1U : 0U;
    node.is_two_sided = bounds.two_sided ? 1U : 0U;
  }

  using Iterator = std::span<std::uint32_t>::iterator;

  /// Orders the lights into two groups, neither of them empty; returns where the second begins.
  Iterator split(std::span<std::uint32_t> items, int depth) {
    if (items.size() > 2 && depth < deepest_cost_split) {
      const CostSplit best = best_split(items);
      if (best.bin >= 0) {
        const auto second = std::partition(items.begin(), items.end(), [&](std::uint32_t light) {
          return bin_of(light, best.axis, best.lower, best.bins_per_metre) <= best.bin;
        });
        if (second != items.begin() && second != items.end()) {
          return second;
        }
      }
    }
    return items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  }

  struct CostSplit {
    int axis = 0;
    int bin = -1;  ///< the last of the first group; -1: no split
    double lower = 0.0;
    double bins_per_metre = 0.0;
    double cost = std::numeric_limits<double>::infinity();
  };

  static int bin_at(double position, double lower, double bins_per_metre) {
    return std::clamp(static_cast<int>((position - lower) * bins_per_metre), 0, most_bins - 1);
  }
  int bin_of(std::uint32_t light, int axis, double lower, double bins_per_metre) const {
    return bin_at(lights_[light].centre()[axis], lower, bins_per_metre);
  }

  CostSplit best_split(std::span<const std::uint32_t> items) const {
    DVec3 lower(std::numeric_limits<double>::infinity());
    DVec3 upper = -lower;
    for (const std::uint32_t light : items) {
      lower = glm::min(lower, lights_[light].centre());
      upper = glm::max(upper, lights_[light].centre());
    }
    const DVec3 extent = upper - lower;
    const double longest = glm::max(extent.x, glm::max(extent.y, extent.z));
    CostSplit best;
    for (int axis = 0; axis < 3; ++axis) {
      if (extent[axis] > 1e-3 * longest) {
        const CostSplit candidate = best_split_along(items, axis, lower[axis], extent[axis]);
        // Thin boxes are worse than their radius says.
        if (candidate.cost * longest / extent[axis] < best.cost) {
          best = candidate;
          best.cost *= longest / extent[axis];
        }
      }
    }
    return best;
  }

  CostSplit best_split_along(std::span<const std::uint32_t> items, int axis, double lower,
                             double extent) const {
    CostSplit best{.axis = axis, .lower = lower, .bins_per_metre = most_bins / extent};
    std::array<LightBounds, most_bins> bins;
    for (const std::uint32_t light : items) {
      LightBounds& bin =
          bins[static_cast<std::size_t>(bin_of(light, axis, lower, best.bins_per_metre))];
      bin = merge(bin, lights_[light]);
    }
    std::array<double, most_bins> cost_above{};  ///< of all bins above this one
    LightBounds above;
    for (std::size_t i = most_bins - 1; i > 0; --i) {
      above = merge(above, bins[i]);
      cost_above[i - 1] = cost_of(above);
    }
    LightBounds below;
    for (std::size_t i = 0; i + 1 < most_bins; ++i) {
      below = merge(below, bins[i]);
      const double cost = cost_of(below) + cost_above[i];
      if (bins[i].intensity > 0.0 && cost < best.cost) {
        best.cost = cost;
        best.bin = static_cast<int>(i);
      }
    }
    return best;
  }

  LightTree& tree_;
  std::span<const LightBounds> lights_;
  std::vector<std::uint32_t>& leaf_of_light_;
  std::vector<std::uint32_t> order_;
  double total_intensity_ = 0.0;
};

LightTree::LightTree(std::span<const LightBounds> lights) { Builder(*this, lights).build(); }

double LightTree::importance(const Node& node, const Receiver& receiver) {
  const Vec3 to_light = node.centre - receiver.position;
  const float squared_distance = glm::dot(to_light, to_light);
  const float squared_radius = std::max(node.radius * node.radius, smallest_squared_distance);
  if (!(squared_distance > squared_radius)) {
    return node.intensity / squared_radius;  // among the lights: they may be in any direction
  }
  const float inverse_distance = 1.0F / std::sqrt(squared_distance);
  const Vec3 direction = to_light * inverse_distance;
  const float sine = node.radius * inverse_distance;
  const Angle half_size{std::sqrt(std::max(0.0F, 1.0F - sine * sine)), sine};

  // The smallest angles, over all points of the sphere around the lights, between a direction they
  // shine to and the one to the receiver, and between the receiver's normal and the light.
  const float axis_cosine = -glm::dot(node.axis, direction);
  const Angle from_axis = angle_of(node.is_two_sided != 0 ? std::abs(axis_cosine) : axis_cosine);
  const Angle spread{node.spread_cosine, node.spread_sine};
  const Angle emission = difference(difference(from_axis, spread), half_size);
  const float normal_cosine = glm::dot(receiver.normal, direction);
  const Angle incidence =
      difference(angle_of(receiver.transmits ? std::abs(normal_cosine) : normal_cosine), half_size);
  if (emission.cosine < node.falloff_cosine - slack || incidence.cosine < -slack) {
    return 0.0;
  }
  const double falloff = inverse_distance;
  return node.intensity * falloff * falloff * std::max(slack, emission.cosine) *
         std::max(slack, incidence.cosine);
}

std::optional<ChosenLight> LightTree::sample(const Receiver& receiver, double u) const {
  constexpr double below_one = 1.0 - std::numeric_limits<double>::epsilon() / 2.0;
  std::uint32_t index = 0;
  double probability = 1.0;
  while (nodes_[index].is_leaf == 0) {
    index = nodes_[index].index;
    const double left = importance(nodes_[index], receiver);
    const double right = importance(nodes_[index + 1], receiver);
    const double both = left + right;
    if (!(both > 0.0)) {
      return std::nullopt;
    }
    // What is left of the random number, stretched to [0, 1), decides below.
    u *= both;
    const bool goes_left = u < left;
    const double taken = goes_left ? left : right;
    u = std::min((goes_left ? u : u - left) / taken, below_one);
    index += goes_left ? 0 : 1;
    probability *= taken / both;
  }
  return ChosenLight{nodes_[index].index, static_cast<float>(probability)};
}

float LightTree::probability(const Receiver& receiver, std::size_t light) const {
  std::uint32_t index = leaf_of_light_[light];
  if (index == no_leaf) {
    return 0.0F;
  }
  double probability = 1.0;
  while (index != 0) {
    const double own = importance(nodes_[index], receiver);
    if (!(own > 0.0)) {
      return 0.0F;
    }
    probability *= own / (own + importance(nodes_[index ^ 1U], receiver));
    index = parent_of_pair_[index / 2];
  }
  return static_cast<float>(probability);
}

}  // namespace foveola
