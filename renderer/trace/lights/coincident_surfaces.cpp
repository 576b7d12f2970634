#include "renderer/trace/lights/coincident_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "renderer/trace/rays/mesh_attributes.h"
#include "renderer/trace/rays/opacity.h"
#include "renderer/trace/surfaces/triangle.h"

namespace foveola {
namespace {

/// A binary tree of boxes: each node splits its boxes along its longest axis.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Bounds> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    add_node(0, static_cast<std::uint32_t>(order_.size()));
  }

  /// Appends the numbers of the boxes that touch `box` to `found`.
  void find(const Bounds& box, std::vector<std::uint32_t>& found, std::uint32_t node = 0) const {
    const Node& here = nodes_[node];
    if (!touch(here.box, box)) {
      return;
    }
    if (here.second != 0) {
      find(box, found, node + 1);
      find(box, found, here.second);
      return;
    }
    for (std::uint32_t i = here.begin; i < here.end; ++i) {
      if (touch(boxes_[order_[i]], box)) {
        found.push_back(order_[i]);
      }
    }
  }

 private:
  struct Node {
    Bounds box;
    std::uint32_t begin, end;
    std::uint32_t second = 0;  ///< the second child; the first follows its parent; 0: a leaf
  };

  static bool touch(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) &&
           glm::all(glm::lessThanEqual(b.lower, a.upper));
  }

  void add_node(std::uint32_t begin, std::uint32_t end) {
    constexpr std::uint32_t leaf_size = 4;
    const std::size_t node = nodes_.size();
    Bounds box = boxes_[order_[begin]];
    for (std::uint32_t i = begin; i < end; ++i) {
      box.lower = glm::min(box.lower, boxes_[order_[i]].lower);
      box.upper = glm::max(box.upper, boxes_[order_[i]].upper);
    }
    nodes_.push_back({.box = box, .begin = begin, .end = end});
    if (end - begin <= leaf_size) {
      return;
    }
    const Vec3 size = box.upper - box.lower;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return boxes_[a].lower[axis] + boxes_[a].upper[axis] <
                              boxes_[b].lower[axis] + boxes_[b].upper[axis];
                     });
    add_node(begin, middle);
    nodes_[node].second = static_cast<std::uint32_t>(nodes_.size());
    add_node(middle, end);
  }

  std::vector<Bounds> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

bool is_left_out(const Scene& scene, const Mesh& mesh) {
  return is_invisible(scene, mesh) ||
         (material_of(scene, mesh).alpha_mode == AlphaMode::blend && has_opacity(scene, mesh));
}

}  // namespace

CoincidentSurfaces::CoincidentSurfaces(const Scene& scene, std::span<const SceneTriangle> emitters)
    : scene_(scene), is_concerned_(scene.object_count(), false) {
  const auto box_of = [&](const SceneTriangle& place) {
    const Triangle triangle(scene, place.object, place.triangle);
    const Vec3 margin(triangle.rounding_error());
    return Bounds{.lower = glm::min(triangle.p0, glm::min(triangle.p1, triangle.p2)) - margin,
                  .upper = glm::max(triangle.p0, glm::max(triangle.p1, triangle.p2)) + margin};
  };
  std::vector<Bounds> boxes;
  for (const SceneTriangle& place : emitters) {
    const Emitter emitter = emitter_of(place);
    if (!is_left_out(scene, scene.mesh_of(place.object)) && is_finite(Vec3(emitter.normal))) {
      emitters_.push_back(emitter);
      boxes.push_back(box_of(place));
    }
  }
  if (emitters_.empty()) {
    return;
  }
  const BoxTree tree(std::move(boxes));
  const std::vector<Bounds> instances = boxes_of_instances(scene);
  std::vector<std::uint32_t> near;
  for (std::uint32_t object = 0; object < scene.object_count(); ++object) {
    const Mesh& mesh = scene.mesh_of(object);
    near.clear();
    if (!is_left_out(scene, mesh)) {
      tree.find(object < scene.meshes.size() ? scene.bounds_of(object)
                                             : instances[object - scene.meshes.size()],
                near);
    }
    if (near.empty()) {
      continue;
    }
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      const SceneTriangle place{.object = object, .triangle = triangle};
      near.clear();
      tree.find(box_of(place), near);
      add_overlaps(place, near);
    }
  }
}

void CoincidentSurfaces::add_overlaps(const SceneTriangle& place,
                                      std::span<const std::uint32_t> near) {
  if (near.empty() || (near.size() == 1 && emitters_[near.front()].place == place)) {
    return;
  }
  const Emitter here = emitter_of(place);
  Overlap overlap;
  bool has_others = false;
  for (const std::uint32_t number : near) {
    const Emitter& emitter = emitters_[number];
    if (emitter.place == place) {
      overlap.emitters.push_back(number);
      continue;
    }
    if (!overlaps(emitter, here)) {
      continue;
    }
    has_others = true;
    overlap.emitters.push_back(number);
    // An emitter overlapped only by surfaces without emission has an entry, too.
    const float clearance = 2.0F * (emitter.tolerance_m + here.tolerance_m);
    Overlap& its_own = overlaps_[emitter.place];
    if (its_own.emitters.empty()) {
      its_own.emitters.push_back(number);
    }
    its_own.clearance_m = std::max(its_own.clearance_m, clearance);
    is_concerned_[emitter.place.object] = true;
    const bool have_a_common_side =
        emitter.double_sided || here.double_sided || glm::dot(emitter.normal, here.normal) > 0.0;
    if (!first_ && have_a_common_side) {
      first_.emplace(emitter.place, place);
    }
  }
  if (has_others) {
    std::ranges::sort(overlap.emitters);
    is_concerned_[place.object] = true;
    Overlap& kept = overlaps_[place];
    kept.emitters = std::move(overlap.emitters);
  }
}

CoincidentSurfaces::Emitter CoincidentSurfaces::emitter_of(const SceneTriangle& place) const {
  const Mesh& mesh = scene_.mesh_of(place.object);
  const Triangle triangle(scene_, place.object, place.triangle);
  const DVec3 corner(triangle.p0);
  const DVec3 side1 = DVec3(triangle.p1) - corner;
  const DVec3 side2 = DVec3(triangle.p2) - corner;
  return {.place = place,
          .corner = corner,
          .side1 = side1,
          .side2 = side2,
          .normal = double{triangle.winding} * glm::normalize(glm::cross(side1, side2)),
          .tolerance_m = triangle.rounding_error(),
          .double_sided = material_of(scene_, mesh).double_sided,
          .has_opacity = has_opacity(scene_, mesh)};
}

bool CoincidentSurfaces::overlaps(const Emitter& emitter, const Emitter& other) {
  const double tolerance = double{emitter.tolerance_m} + other.tolerance_m;
  const auto lies_in_plane = [&](const Emitter& triangle, const Emitter& plane) {
    const auto distance = [&](const DVec3& point) {
      return std::abs(glm::dot(plane.normal, point - plane.corner));
    };
    return distance(triangle.corner) <= tolerance &&
           distance(triangle.corner + triangle.side1) <= tolerance &&
           distance(triangle.corner + triangle.side2) <= tolerance;
  };
  if (!lies_in_plane(emitter, other) && !lies_in_plane(other, emitter)) {
    return false;
  }
  // Triangles in a plane are disjoint if a line along a side of one of them separates them.
  for (const Emitter* triangle : {&emitter, &other}) {
    for (const DVec3& side :
         {triangle->side1, triangle->side2, triangle->side2 - triangle->side1}) {
      const DVec3 axis = glm::normalize(glm::cross(triangle->normal, side));
      const auto extent = [&](const Emitter& of) {
        const double corner = glm::dot(axis, of.corner);
        return std::minmax(
            {corner, corner + glm::dot(axis, of.side1), corner + glm::dot(axis, of.side2)});
      };
      const auto [begin, end] = extent(emitter);
      const auto [other_begin, other_end] = extent(other);
      if (std::min(end, other_end) - std::max(begin, other_begin) <= tolerance) {
        return false;
      }
    }
  }
  return true;
}

const CoincidentSurfaces::Overlap* CoincidentSurfaces::overlap_of(
    const SceneTriangle& place) const {
  if (!is_concerned_[place.object]) {
    return nullptr;
  }
  const auto found = overlaps_.find(place);
  return found != overlaps_.end() ? &found->second : nullptr;
}

bool CoincidentSurfaces::shines(const Emitter& emitter, const Vec3& direction) const {
  return emitter.double_sided || glm::dot(emitter.normal, DVec3(direction)) < 0.0;
}

std::optional<Vec2> CoincidentSurfaces::find(const Emitter& emitter, const DVec3& point) const {
  constexpr double tolerance = 1e-6;
  const DVec3 to_point = point - emitter.corner;
  const DVec3 across = glm::cross(emitter.side1, emitter.side2);
  const double scale = 1.0 / glm::dot(across, across);
  const double u = scale * glm::dot(glm::cross(to_point, emitter.side2), across);
  const double v = scale * glm::dot(glm::cross(emitter.side1, to_point), across);
  if (!(u >= -tolerance && v >= -tolerance && u + v <= 1.0 + tolerance)) {
    return std::nullopt;
  }
  const Vec2 barycentric(std::clamp(u, 0.0, 1.0), std::clamp(v, 0.0, 1.0));
  const auto& [object, triangle] = emitter.place;
  const bool is_there =
      !emitter.has_opacity || opacity(scene_, scene_.mesh_of(object), triangle, barycentric) > 0.0F;
  return is_there ? std::optional(barycentric) : std::nullopt;
}

Hit CoincidentSurfaces::seen(const Hit& hit, const Vec3& direction) const {
  const Overlap* const overlap = overlap_of({.object = hit.object, .triangle = hit.triangle});
  if (overlap == nullptr) {
    return hit;
  }
  const DVec3 point(Triangle(scene_, hit.object, hit.triangle).at(hit.barycentric));
  for (const std::uint32_t number : overlap->emitters) {
    const Emitter& emitter = emitters_[number];
    if (!shines(emitter, direction)) {
      continue;
    }
    if (const std::optional<Vec2> barycentric = find(emitter, point)) {
      return {.t = hit.t,
              .barycentric = *barycentric,
              .object = emitter.place.object,
              .triangle = emitter.place.triangle};
    }
  }
  return hit;
}

bool CoincidentSurfaces::is_seen(const SceneTriangle& emitter, const Vec3& point,
                                 const Vec3& direction) const {
  const Overlap* const overlap = overlap_of(emitter);
  if (overlap == nullptr) {
    return true;
  }
  for (const std::uint32_t number : overlap->emitters) {
    const Emitter& other = emitters_[number];
    if (other.place == emitter) {
      return true;
    }
    if (shines(other, direction) && find(other, DVec3(point))) {
      return false;
    }
  }
  return true;
}

bool CoincidentSurfaces::may_be_hidden(const SceneTriangle& emitter) const {
  const Overlap* const overlap = overlap_of(emitter);
  return overlap != nullptr && emitters_[overlap->emitters.front()].place != emitter;
}

float CoincidentSurfaces::clearance_m(const SceneTriangle& emitter) const {
  const Overlap* const overlap = overlap_of(emitter);
  return overlap != nullptr ? overlap->clearance_m : 0.0F;
}

std::optional<std::string> CoincidentSurfaces::warning() const {
  if (!first_) {
    return std::nullopt;
  }
  const auto name = [&](const SceneTriangle& place) {
    const std::string& given = scene_.object_name(place.object);
    return given.empty() ? fmt::format("object {}", place.object) : fmt::format("'{}'", given);
  };
  return fmt::format(
      "{} emits light in one plane with {}, which it overlaps: of overlapping surfaces the first "
      "emitter is visible, and it alone lights the scene ({} triangles)",
      name(first_->first), name(first_->second), overlaps_.size());
}

}  // namespace foveola
