#include "renderer/trace/lights/light_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>

namespace foveola {
namespace {

/// Below this depth lights are halved by number, so that no arrangement degenerates the tree into a
/// list.
constexpr int deepest_cost_split = 40;

constexpr int max_bins = 12;

/// Bound on the errors of angles' cosines: an error of 1e-7 in a cosine near 1 is an error of 4e-4
/// in the angle. No light is excluded for facing away by less.
constexpr float slack = 1e-3F;

/// In square metres; keeps quotients by it finite.
constexpr float smallest_squared_distance = 1e-20F;

/// Replaces the sine of a sphere's half angle for points inside.
constexpr float inside = 2.0F;

/// Minimum importance of a child relative to its strongest sibling, so that a light that reaches
/// the shading point never has none.
constexpr float smallest_importance = 1e-30F;

struct Angle {
  float cosine;
  float sine;
};

Angle angle_of(float cosine) { return {cosine, std::sqrt(std::max(0.0F, 1.0F - cosine * cosine))}; }

/// max(0, a - b), for angles in [0, pi]. Without branches, for loops over lanes.
Angle difference(const Angle& a, const Angle& b) {
  const bool is_zero = a.cosine > b.cosine;
  const float cosine = a.cosine * b.cosine + a.sine * b.sine;
  const float sine = a.sine * b.cosine - a.cosine * b.sine;
  return {is_zero ? 1.0F : cosine, is_zero ? 0.0F : sine};
}

/// The surface area orientation heuristic of one side of a split: intensity times extent in space
/// and direction.
double cost_of(const LightBounds& bounds) {
  const double radius = bounds.radius();
  return bounds.intensity * orientation_measure(bounds) * radius * radius;
}

}  // namespace

class LightTree::Builder {
 public:
  Builder(LightTree& tree, std::span<const LightBounds> lights) : tree_(tree), lights_(lights) {
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
      if (lights[i].intensity > 0.0) {
        order_.push_back(i);
      }
    }
  }

  void build() {
    assert(!order_.empty());
    tree_.leaf_of_light_.assign(lights_.size(), Place{});
    std::deque<Group> waiting;
    add_node(group_of(order_, 0), Place{}, waiting);
    for (std::uint32_t node = 0; !waiting.empty(); ++node) {
      fill_node(node, waiting);
    }
  }

 private:
  /// Lights under one child.
  struct Group {
    std::span<std::uint32_t> lights;
    LightBounds bounds;
    int depth;  ///< number of splits above it
  };

  Group group_of(std::span<std::uint32_t> items, int depth) const {
    LightBounds bounds;
    for (const std::uint32_t light : items) {
      bounds = merge(bounds, lights_[light]);
    }
    return {items, bounds, depth};
  }

  /// Adds an empty node for a group, and queues its children; returns its index.
  std::uint32_t add_node(const Group& group, const Place& parent, std::deque<Group>& waiting) {
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    tree_.parent_of_node_.push_back(parent);
    waiting.push_back(group);
    return index;
  }

  /// Fills the node of the longest waiting group.
  void fill_node(std::uint32_t index, std::deque<Group>& waiting) {
    const Group group = waiting.front();
    waiting.pop_front();
    const std::vector<Group> children = children_of(group);
    for (std::uint32_t lane = 0; lane < children.size(); ++lane) {
      fill(tree_.nodes_[index], lane, children[lane].bounds, group.bounds.intensity);
      const Place place{index, lane};
      std::uint32_t child = 0;
      if (children[lane].lights.size() == 1) {
        child = children[lane].lights[0];
        tree_.leaf_of_light_[child] = place;
        child |= leaf_flag;
      } else {
        child = add_node(children[lane], place, waiting);
      }
      tree_.nodes_[index].child[lane] = child;
    }
  }

  /// Splits the most expensive groups, until there are enough.
  std::vector<Group> children_of(const Group& group) {
    std::vector<Group> children{group};
    while (children.size() < width) {
      const auto costliest = std::ranges::max_element(children, [](const Group& a, const Group& b) {
        return cost_to_keep(a) < cost_to_keep(b);
      });
      if (costliest->lights.size() == 1) {
        break;
      }
      const Group whole = *costliest;
      const auto first =
          static_cast<std::size_t>(split(whole.lights, whole.depth) - whole.lights.begin());
      *costliest = group_of(whole.lights.first(first), whole.depth + 1);
      children.push_back(group_of(whole.lights.subspan(first), whole.depth + 1));
    }
    return children;
  }

  /// Single lights cannot be split; groups can, even at no cost.
  static double cost_to_keep(const Group& group) {
    return group.lights.size() == 1 ? -1.0 : cost_of(group.bounds);
  }

  static void fill(Node& node, std::uint32_t lane, const LightBounds& bounds,
                   double total_intensity) {
    const Vec3 centre(bounds.centre());
    const Vec3 axis(bounds.axis);
    const Vec3 furthest = glm::max(glm::abs(bounds.box.lower), glm::abs(bounds.box.upper));
    const double rounding = 4.0 * std::numeric_limits<float>::epsilon() * max_component(furthest);
    for (int i = 0; i < 3; ++i) {
      node.centre[static_cast<std::size_t>(i)][lane] = centre[i];
      node.axis[static_cast<std::size_t>(i)][lane] = axis[i];
    }
    node.radius[lane] = static_cast<float>(bounds.radius() * (1.0 + 1e-5) + rounding);
    node.spread_cosine[lane] = static_cast<float>(std::cos(bounds.spread_rad));
    node.spread_sine[lane] = static_cast<float>(std::sin(bounds.spread_rad));
    node.falloff_cosine[lane] = static_cast<float>(std::cos(bounds.falloff_rad));
    node.intensity[lane] = std::max(static_cast<float>(bounds.intensity / total_intensity),
                                    std::numeric_limits<float>::min());
    node.is_two_sided[lane] = bounds.two_sided ? 1U : 0U;
  }

  using Iterator = std::span<std::uint32_t>::iterator;

  /// Splits the lights into two non-empty groups; returns the beginning of the second.
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
    return std::clamp(static_cast<int>((position - lower) * bins_per_metre), 0, max_bins - 1);
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
        // For thin boxes the radius underestimates the cost.
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
    CostSplit best{.axis = axis, .lower = lower, .bins_per_metre = max_bins / extent};
    std::array<LightBounds, max_bins> bins;
    for (const std::uint32_t light : items) {
      LightBounds& bin =
          bins[static_cast<std::size_t>(bin_of(light, axis, lower, best.bins_per_metre))];
      bin = merge(bin, lights_[light]);
    }
    std::array<double, max_bins> cost_above{};  ///< cost of all bins above this one
    LightBounds above;
    for (std::size_t i = max_bins - 1; i > 0; --i) {
      above = merge(above, bins[i]);
      cost_above[i - 1] = cost_of(above);
    }
    LightBounds below;
    for (std::size_t i = 0; i + 1 < max_bins; ++i) {
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
  std::vector<std::uint32_t> order_;
};

LightTree::LightTree(std::span<const LightBounds> lights) { Builder(*this, lights).build(); }

LightTree::Lanes LightTree::importance(const Node& node, const ShadingPoint& shading_point) {
  const Vec3 place = shading_point.position;
  const Vec3 normal = shading_point.normal;
  Lanes squared_distance;
  Lanes normal_cosine;
  Lanes axis_cosine;
  Lanes half_size_sine;
  for (std::size_t i = 0; i < width; ++i) {
    const float x = node.centre[0][i] - place.x;
    const float y = node.centre[1][i] - place.y;
    const float z = node.centre[2][i] - place.z;
    const float squared_radius =
        std::max(node.radius[i] * node.radius[i], smallest_squared_distance);
    const float squared = x * x + y * y + z * z;
    squared_distance[i] = std::max(squared, squared_radius);
    const float inverse = 1.0F / std::sqrt(squared_distance[i]);
    half_size_sine[i] = squared > squared_radius ? node.radius[i] * inverse : inside;
    normal_cosine[i] = (normal.x * x + normal.y * y + normal.z * z) * inverse;
    const float cosine =
        -(node.axis[0][i] * x + node.axis[1][i] * y + node.axis[2][i] * z) * inverse;
    axis_cosine[i] = node.is_two_sided[i] != 0 ? std::abs(cosine) : cosine;
  }
  if (shading_point.transmits) {
    for (float& cosine : normal_cosine) {
      cosine = std::abs(cosine);
    }
  }
  // The minimum angles, over all points of the bounding sphere, between an emission direction and
  // that to the shading point, and between the shading point's normal and the light. Inside the
  // sphere the lights may be in any direction.
  Lanes cosines;
  for (std::size_t i = 0; i < width; ++i) {
    const float sine = half_size_sine[i];
    const Angle half_size{std::sqrt(std::max(0.0F, 1.0F - sine * sine)), sine};
    const Angle spread{node.spread_cosine[i], node.spread_sine[i]};
    const Angle emission = difference(difference(angle_of(axis_cosine[i]), spread), half_size);
    const Angle incidence = difference(angle_of(normal_cosine[i]), half_size);
    const float both = std::max(slack, emission.cosine) * std::max(slack, incidence.cosine);
    const float emitted = emission.cosine >= node.falloff_cosine[i] - slack ? both : 0.0F;
    const float received = incidence.cosine >= -slack ? emitted : 0.0F;
    cosines[i] = sine == inside ? 1.0F : received;
  }
  const float nearest = *std::ranges::min_element(squared_distance);
  Lanes result;
  for (std::size_t i = 0; i < width; ++i) {
    const float value = node.intensity[i] * (nearest / squared_distance[i]) * cosines[i];
    const float given = cosines[i] > 0.0F ? std::max(value, smallest_importance) : 0.0F;
    result[i] = node.intensity[i] > 0.0F ? given : 0.0F;
  }
  return result;
}

LightTree::Lanes LightTree::weights(std::uint32_t node, const ShadingPoint& shading_point,
                                    const Preferences* preferences) const {
  Lanes weights = importance(nodes_[node], shading_point);
  if (preferences != nullptr && node < preferring_nodes) {
    for (std::size_t i = 0; i < width; ++i) {
      weights[i] *= (*preferences)[node][i];
    }
  }
  return weights;
}

std::optional<ChosenLight> LightTree::sample(const ShadingPoint& shading_point, double u,
                                             const Preferences* preferences) const {
  constexpr double below_one = 1.0 - std::numeric_limits<double>::epsilon() / 2.0;
  std::uint32_t child = 0;
  double probability = 1.0;
  do {
    const Node& node = nodes_[child];
    const Lanes weights = this->weights(child, shading_point, preferences);
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    if (!(sum > 0.0)) {
      return std::nullopt;
    }
    // The rest of the random number, rescaled to [0, 1), decides below.
    u *= sum;
    std::size_t lane = 0;
    for (std::size_t next = 0; next < width; ++next) {
      if (weights[next] > 0.0F) {
        lane = next;
        if (u < weights[next]) {
          break;
        }
        u -= weights[next];
      }
    }
    u = std::min(u / weights[lane], below_one);
    probability *= weights[lane] / sum;
    child = node.child[lane];
  } while ((child & leaf_flag) == 0);
  return ChosenLight{child & ~leaf_flag, static_cast<float>(probability)};
}

float LightTree::probability(const ShadingPoint& shading_point, std::size_t light,
                             const Preferences* preferences) const {
  Place place = leaf_of_light_[light];
  double probability = place.node == nowhere ? 0.0 : 1.0;
  while (place.node != nowhere && probability > 0.0) {
    const Lanes weights = this->weights(place.node, shading_point, preferences);
    const double own = weights[place.lane];
    probability =
        own > 0.0 ? probability * own / std::accumulate(weights.begin(), weights.end(), 0.0) : 0.0;
    place = parent_of_node_[place.node];
  }
  return static_cast<float>(probability);
}

}  // namespace foveola
