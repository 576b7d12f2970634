#include "renderer/scene/gltf/nodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/scene/gltf_file/fault.h"
#include "renderer/scene/gltf_file/values.h"
#include "renderer/scene/gltf_mesh/accessor.h"
#include "renderer/scene/gltf_mesh/deformation.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

constexpr int no_parent = -1;

/// Each node's parent. Throws unless every node has at most one.
std::vector<int> parents_of(const std::vector<GltfNode>& nodes) {
  std::vector<int> parents(nodes.size(), no_parent);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t k = 0; k < nodes[i].children.size(); ++k) {
      const int child = nodes[i].children[k];
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent != no_parent) {
        throw GltfFault(fmt::format("nodes[{}].children[{}]", i, k),
                        fmt::format("node {} has two parents, nodes {} and {}", child, parent, i));
      }
      parent = static_cast<int>(i);
    }
  }
  return parents;
}

/// With one parent each, the nodes form trees and cycles. Climbing from every node finds the
/// cycles, and stops at nodes cleared by an earlier climb.
void reject_cycles(const std::vector<int>& parents) {
  constexpr std::size_t not_visited = 0;
  std::vector<std::size_t> visited_by(parents.size(), not_visited);
  for (std::size_t start = 0; start < parents.size(); ++start) {
    const std::size_t climb = start + 1;
    int node = static_cast<int>(start);
    while (node != no_parent && visited_by[static_cast<std::size_t>(node)] == not_visited) {
      visited_by[static_cast<std::size_t>(node)] = climb;
      node = parents[static_cast<std::size_t>(node)];
    }
    if (node != no_parent && visited_by[static_cast<std::size_t>(node)] == climb) {
      throw GltfFault(fmt::format("nodes[{}]", node), "the nodes form a cycle");
    }
  }
}

std::vector<int> roots_without_scenes(const std::vector<int>& parents) {
  std::vector<int> roots;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] == no_parent) {
      roots.push_back(static_cast<int>(i));
    }
  }
  return roots;
}

std::vector<int> root_nodes(const GltfModel& model, const std::vector<int>& parents) {
  const GltfValues document = model.root();
  if (document.size("scenes") == 0) {
    return roots_without_scenes(parents);
  }
  const std::size_t scene = document.natural("scene");
  std::vector<int> roots = document.item("scenes", scene).integers("nodes");
  std::vector<bool> listed(parents.size(), false);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const auto root = static_cast<std::size_t>(roots[i]);
    const auto place = [&] { return fmt::format("scenes[{}].nodes[{}]", scene, i); };
    if (parents[root] != no_parent) {
      throw GltfFault(place(), fmt::format("node {} is not a root: its parent is node {}", root,
                                           parents[root]));
    }
    if (listed[root]) {
      throw GltfFault(place(), fmt::format("node {} is listed twice", root));
    }
    listed[root] = true;
  }
  return roots;
}

DVec3 vector_or(const std::vector<double>& numbers, const DVec3& absent) {
  return numbers.empty() ? absent : glm::make_vec3(numbers.data());
}

std::string place_of(int node) { return fmt::format("nodes[{}]", node); }

/// numbers: x, y, z and w of a quaternion.
template <typename Number>
DMat4 rotation_of(const Number* numbers, int node) {
  const glm::dquat rotation(numbers[3], numbers[0], numbers[1], numbers[2]);
  const double length = glm::length(rotation);
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw GltfFault(place_of(node) + ".rotation", "is not a rotation");
  }
  return glm::mat4_cast(rotation / length);
}

DMat4 parent_from_local(const GltfNode& node, int index) {
  if (!node.matrix.empty()) {
    DMat4 matrix = glm::make_mat4(node.matrix.data());
    for (int column = 0; column < 4; ++column) {
      matrix[column][3] = column < 3 ? 0.0 : 1.0;  // the last row of affine transforms
    }
    return matrix;
  }
  const DMat4 translation = glm::translate(DMat4(1.0), vector_or(node.translation, DVec3(0.0)));
  const DMat4 rotation =
      node.rotation.empty() ? DMat4(1.0) : rotation_of(node.rotation.data(), index);
  return glm::scale(translation * rotation, vector_or(node.scale, DVec3(1.0)));
}

void require_finite(const DMat4& matrix, int node) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) {
        throw GltfFault(place_of(node), "its transform is not finite");
      }
    }
  }
}

/// Transforms of the node's mesh by EXT_mesh_gpu_instancing, in the node's coordinates; one
/// identity without it.
std::vector<DMat4> instances_of(const GltfModel& model, const GltfNode& node, int index) {
  const GltfIndices& attributes = node.instance_attributes;
  const std::string place = place_of(index) + ".extensions.EXT_mesh_gpu_instancing.attributes";
  std::optional<std::size_t> count;
  const auto read = [&](const std::string& name, int components) {
    std::vector<float> numbers;
    if (const auto accessor = attributes.find(name); accessor != attributes.end()) {
      const std::string where = fmt::format("{}.{}", place, name);
      numbers = read_numbers(model, accessor->second, components, where);
      const std::size_t elements = element_count(model, accessor->second);
      if (count.value_or(elements) != elements) {
        throw GltfFault(where, "has another number of instances than the others");
      }
      count = elements;
    }
    return numbers;
  };
  const std::vector<float> translations = read("TRANSLATION", 3);
  const std::vector<float> rotations = read("ROTATION", 4);
  const std::vector<float> scales = read("SCALE", 3);
  std::vector<DMat4> instances(count.value_or(1), DMat4(1.0));
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (!translations.empty()) {
      instances[i] = glm::translate(instances[i], DVec3(glm::make_vec3(&translations[3 * i])));
    }
    if (!rotations.empty()) {
      instances[i] *= rotation_of(&rotations[4 * i], index);
    }
    if (!scales.empty()) {
      instances[i] = glm::scale(instances[i], DVec3(glm::make_vec3(&scales[3 * i])));
    }
    require_finite(instances[i], index);
  }
  return instances;
}

/// Nodes may share an accessor, so that a small file can name any number.
void require_few_instances(std::size_t count, int node) {
  constexpr std::size_t max_instances = std::size_t{1} << 22;
  if (count > max_instances) {
    throw GltfFault(place_of(node),
                    fmt::format("the scene has more than {} instances of meshes", max_instances));
  }
}

/// A camera's heading: it looks along its -Z, upright along its +Y. Straight up or down, the
/// picture's upright direction gives the azimuth.
AzimuthElevation heading_of(const DMat4& world_from_local) {
  constexpr double vertical = 1e-6;  // to either side, in radians: rounding of a right angle
  const DVec3 forward = -DVec3(world_from_local[2]);
  const DVec3 up = DVec3(world_from_local[1]);
  AzimuthElevation heading = azimuth_elevation(Vec3(forward));
  if (std::hypot(forward.x, forward.z) < vertical * std::abs(forward.y)) {
    heading.azimuth_rad = azimuth_elevation(Vec3(forward.y < 0.0 ? up : -up)).azimuth_rad;
  }
  return heading;
}

/// See CameraView; 0 for possible rounding.
double roll_of(const DMat4& world_from_local, const AzimuthElevation& heading) {
  constexpr double smallest_roll_rad = 1e-3;
  const DVec3 back(world_from_local[2]);
  const DVec3 right = glm::cross(DVec3(world_from_local[1]), back);
  const DVec3 level(std::cos(heading.azimuth_rad), 0.0, std::sin(heading.azimuth_rad));
  const DVec3 level_up = glm::cross(back / glm::length(back), level);
  const double roll_rad = std::atan2(-glm::dot(right, level_up), glm::dot(right, level));
  return std::abs(roll_rad) > smallest_roll_rad ? roll_rad : 0.0;
}

/// The field of view and the aspect ratio of a perspective camera, if valid.
void read_lens(const GltfValues& lens, CameraView& view) {
  const double fov_rad = lens.number("yfov", 0.0);
  if (fov_rad > 0.0 && fov_rad < std::numbers::pi) {
    view.vertical_fov_rad = fov_rad;
  }
  const double aspect_ratio = lens.number("aspectRatio", 0.0);
  if (aspect_ratio > 0.0 && std::isfinite(aspect_ratio)) {
    view.aspect_ratio = aspect_ratio;
  }
}

}  // namespace

PlacedNodes place_nodes(const GltfModel& model, Warnings& warnings) {
  const std::vector<int> parents = parents_of(model.nodes);
  reject_cycles(parents);

  PlacedNodes placed;
  placed.meshes.resize(model.meshes.size());
  std::vector<DMat4> world_from_local(model.nodes.size(), DMat4(1.0));
  std::vector<bool> is_hidden(model.nodes.size());
  std::size_t instance_count = 0;
  const std::vector<int> roots = root_nodes(model, parents);
  std::vector<int> pending(roots.rbegin(), roots.rend());
  while (!pending.empty()) {
    const int index = pending.back();
    pending.pop_back();
    const GltfNode& node = model.nodes[static_cast<std::size_t>(index)];
    const int parent = parents[static_cast<std::size_t>(index)];
    DMat4& transform = world_from_local[static_cast<std::size_t>(index)];
    transform = parent_from_local(node, index);
    bool is_shown = node.is_visible;
    if (parent != no_parent) {
      transform = world_from_local[static_cast<std::size_t>(parent)] * transform;
      is_shown = is_shown && !is_hidden[static_cast<std::size_t>(parent)];
    }
    is_hidden[static_cast<std::size_t>(index)] = !is_shown;
    require_finite(transform, index);
    const Placement placement{.node = index, .world_from_local = transform};
    if (node.mesh >= 0 && is_shown) {
      std::vector<Placement>& places = placed.meshes[static_cast<std::size_t>(node.mesh)];
      if (is_skinned(model, node)) {  // by its joints, which are in the world
        places.push_back({.node = index});
      } else {
        const std::vector<DMat4> instances = instances_of(model, node, index);
        instance_count += instances.size();
        require_few_instances(instance_count, index);
        for (const DMat4& instance : instances) {
          places.push_back({.node = index, .world_from_local = transform * instance});
          require_finite(places.back().world_from_local, index);
        }
        if (node.skin >= 0) {
          warnings.add("a skin is ignored: its mesh has no joints or no weights", place_of(index));
        }
      }
    }
    if (node.camera >= 0) {
      placed.cameras.push_back(
          {.index = static_cast<std::size_t>(node.camera), .placement = placement});
    }
    if (node.light >= 0 && is_shown) {
      placed.lights.push_back(
          {.index = static_cast<std::size_t>(node.light), .placement = placement});
    }
    pending.insert(pending.end(), node.children.rbegin(), node.children.rend());
  }
  placed.world_from_node = std::move(world_from_local);
  return placed;
}

std::vector<CameraView> read_cameras(const GltfModel& model, const std::vector<PlacedItem>& cameras,
                                     const DVec3& origin, Warnings& warnings) {
  std::vector<CameraView> views;
  for (const PlacedItem& item : cameras) {
    const GltfValues camera = model.root().item("cameras", item.index);
    const GltfNode& node = model.nodes[static_cast<std::size_t>(item.placement.node)];
    const std::string place = place_of(item.placement.node);
    if (camera.text("type") != "perspective") {
      warnings.add("orthographic cameras are ignored", place);
      continue;
    }
    const DMat4& world_from_local = item.placement.world_from_local;
    const AzimuthElevation heading = heading_of(world_from_local);
    const std::string name = camera.text("name");
    CameraView view{.name = sanitised(name.empty() ? node.name : name),
                    .position = Vec3(DVec3(world_from_local[3]) - origin),
                    .heading = heading,
                    .roll_rad = roll_of(world_from_local, heading),
                    .vertical_fov_rad = std::nullopt,
                    .aspect_ratio = std::nullopt};
    if (view.roll_rad != 0.0) {
      warnings.add(
          "camera roll is used by 'foveola render' only; previews and panoramas keep the horizon "
          "level",
          place);
    }
    read_lens(camera.object("perspective"), view);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace foveola
