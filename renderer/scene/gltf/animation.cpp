#include "renderer/scene/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/gtc/quaternion.hpp>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"
#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_mesh/accessor.h"
#include "renderer/scene/prepare/made_up_names.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

using Values = std::vector<double>;

/// Interpolation of a sampler between keys.
struct Keys {
  std::vector<float> times;  ///< seconds
  std::vector<float>
      numbers;  ///< `width` per key, or three times that: in-tangent, value, out-tangent
  std::size_t width = 0;
  std::string interpolation;

  bool is_cubic() const { return interpolation == "CUBICSPLINE"; }
  /// part: of a cubic's key, 0 the in-tangent, 1 the value, 2 the out-tangent.
  Values at(std::size_t key, std::size_t part = 1) const {
    const std::size_t begin = is_cubic() ? (3 * key + part) * width : key * width;
    const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(begin);
    return {first, first + static_cast<std::ptrdiff_t>(width)};
  }
};

glm::dquat quaternion_of(const Values& v) { return {v[3], v[0], v[1], v[2]}; }

Values normalised(const glm::dquat& rotation) {
  const glm::dquat unit = glm::normalize(rotation);
  return {unit.x, unit.y, unit.z, unit.w};
}

Values on_line(const Values& from, const Values& to, double share, bool is_rotation) {
  if (is_rotation) {
    return normalised(glm::slerp(quaternion_of(from), quaternion_of(to), share));
  }
  Values result(from.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::lerp(from[i], to[i], share);
  }
  return result;
}

/// Appendix C.5: a Hermite spline whose tangents are per second.
Values on_spline(const Keys& keys, std::size_t key, double share, bool is_rotation) {
  const double seconds = static_cast<double>(keys.times[key + 1]) - keys.times[key];
  const double t2 = share * share;
  const double t3 = t2 * share;
  const Values from = keys.at(key);
  const Values out = keys.at(key, 2);
  const Values in = keys.at(key + 1, 0);
  const Values to = keys.at(key + 1);
  Values result(keys.width);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * from[i] + seconds * (t3 - 2.0 * t2 + share) * out[i] +
                (3.0 * t2 - 2.0 * t3) * to[i] + seconds * (t3 - t2) * in[i];
  }
  return is_rotation ? normalised(quaternion_of(result)) : result;
}

Values value_at(const Keys& keys, double time_s, bool is_rotation) {
  const auto next = std::upper_bound(keys.times.begin(), keys.times.end(), time_s);
  if (next == keys.times.begin()) {
    return keys.at(0);
  }
  const auto key = static_cast<std::size_t>(next - keys.times.begin()) - 1;
  if (next == keys.times.end() || keys.interpolation == "STEP") {
    return keys.at(key);
  }
  const double share = (time_s - keys.times[key]) / (static_cast<double>(*next) - keys.times[key]);
  return keys.is_cubic() ? on_spline(keys, key, share, is_rotation)
                         : on_line(keys.at(key), keys.at(key + 1), share, is_rotation);
}

/// Poses channels one by one.
class Poser {
 public:
  Poser(const GltfModel& model, double time_s, Warnings& warnings)
      : model_(model), time_s_(time_s), warnings_(warnings) {}

  /// path: the animated property of `node`.
  void pose(GltfNode& node, const std::string& path, const GltfValues& sampler,
            const std::string& place) {
    if (path == "weights") {
      node.weights = value(sampler, 1, weights_of(node), false, place);
      return;
    }
    const bool is_rotation = path == "rotation";
    if (!is_rotation && path != "translation" && path != "scale") {
      warnings_.add(fmt::format("animations of \"{}\" are ignored", sanitised(path)), place);
      return;
    }
    if (!node.matrix.empty()) {
      warnings_.add("animations of nodes that have a matrix are ignored", place);
      return;
    }
    const int components = is_rotation ? 4 : 3;
    Values& target = is_rotation             ? node.rotation
                     : path == "translation" ? node.translation
                                             : node.scale;
    target = value(sampler, components, 1, is_rotation, place);
  }

 private:
  /// Number of morph targets of the node's mesh.
  std::size_t weights_of(const GltfNode& node) const {
    return node.mesh < 0 ? 0
                         : model_.meshes[static_cast<std::size_t>(node.mesh)]
                               .primitives.front()
                               .targets.size();
  }

  /// per_key: number of elements of the sampler's output per key, without a cubic's tangents.
  Values value(const GltfValues& sampler, int components, std::size_t per_key, bool is_rotation,
               const std::string& place) {
    const Keys keys{.times = numbers(sampler.integer("input"), 1, place + ".input"),
                    .numbers = numbers(sampler.integer("output"), components, place + ".output"),
                    .width = static_cast<std::size_t>(components) * per_key,
                    .interpolation = sampler.text("interpolation")};
    const std::size_t parts = keys.is_cubic() ? 3 : 1;
    if (keys.numbers.size() < parts * keys.width * keys.times.size()) {
      throw GltfFault(place,
                      fmt::format("has {} times, but {} numbers of {} each", keys.times.size(),
                                  keys.numbers.size(), parts * keys.width));
    }
    if (!std::ranges::is_sorted(keys.times)) {
      throw GltfFault(place, "has times that are not in order");
    }
    return value_at(keys, time_s_, is_rotation);
  }

  /// Samplers may share accessors, so their number alone bounds nothing.
  std::vector<float> numbers(int accessor, int components, const std::string& place) {
    constexpr std::size_t most = std::size_t{1} << 27;
    read_ += element_count(model_, accessor) * static_cast<std::size_t>(components);
    if (read_ > most) {
      throw GltfFault(place, fmt::format("the animations hold more than {} keyframe values", most));
    }
    return read_numbers(model_, accessor, components, place);
  }

  const GltfModel& model_;
  double time_s_;
  Warnings& warnings_;
  std::size_t read_ = 0;
};

std::string listed(const std::vector<std::string>& names) {
  const std::vector<std::string> texts = transformed(
      names, [&](const std::string& name) { return fmt::format("'{}'", sanitised(name)); });
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace

std::vector<std::string> clip_names(const GltfModel& model) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.root().size("animations"); ++i) {
    names.push_back(model.root().item("animations", i).text("name"));
  }
  return distinct_names(std::move(names), "clip");
}

void pose_at(GltfModel& model, double time_s, const std::string& clip, Warnings& warnings) {
  const std::vector<std::string> names = clip_names(model);
  if (!clip.empty() && std::ranges::find(names, clip) == names.end()) {
    throw UsageError(
        "--clip", fmt::format("the file has no clip '{}'", sanitised(clip)),
        names.empty() ? "it has none at all: leave it out" : "it has " + listed(names));
  }
  Poser poser(model, time_s, warnings);
  std::map<std::pair<int, std::string>, std::size_t> last_mover;  // by node and property
  bool overlaps = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const GltfValues animation = model.root().item("animations", i);
    for (std::size_t k = 0; k < animation.size("channels"); ++k) {
      const GltfValues channel = animation.item("channels", k);
      const int node = channel.object("target").integer("node");
      if ((!clip.empty() && names[i] != clip) || node < 0) {
        continue;
      }
      const std::string path = channel.object("target").text("path");
      const std::size_t sampler = channel.natural("sampler");
      const auto [mover, is_new] = last_mover.try_emplace({node, path}, i);
      if (!is_new && mover->second == i) {
        warnings.add("a clip moves one property of a node twice, and the last channel wins",
                     fmt::format("animations[{}].channels[{}]", i, k));
      }
      overlaps |= std::exchange(mover->second, i) != i;
      poser.pose(model.nodes[static_cast<std::size_t>(node)], path,
                 animation.item("samplers", sampler),
                 fmt::format("animations[{}].samplers[{}]", i, sampler));
    }
  }
  if (overlaps) {
    warnings.add(fmt::format(
        "the clips {} move the same nodes, and the last one wins; --clip NAME chooses one",
        listed(names)));
  }
}

}  // namespace foveola
