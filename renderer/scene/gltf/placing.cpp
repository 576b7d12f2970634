#include "renderer/scene/gltf/placing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/work/work_scope.h"
#include "renderer/scene/prepare/mesh_edit.h"
#include "renderer/scene/prepare/rebase.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace {

struct DBounds {
  DVec3 lower{std::numeric_limits<double>::infinity()};
  DVec3 upper{-std::numeric_limits<double>::infinity()};

  void include(const DVec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  bool is_empty() const { return lower.x > upper.x; }
};

DBounds bounds_of(const LocalMesh& meshes) {
  DBounds bounds;
  for (const Mesh& mesh : meshes) {
    for (const Vec3& position : mesh.positions) {
      bounds.include(DVec3(position));
    }
  }
  return bounds;
}

/// Extends `world` by the transformed `local`.
void include(DBounds& world, const DBounds& local, const DMat4& world_from_local) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    const DVec3 point((corner & 1U) != 0 ? local.lower.x : local.upper.x,
                      (corner & 2U) != 0 ? local.lower.y : local.upper.y,
                      (corner & 4U) != 0 ? local.lower.z : local.upper.z);
    world.include(DVec3(world_from_local * glm::dvec4(point, 1.0)));
  }
}

DMat4 seen_from(const DVec3& origin, const DMat4& world_from_local) {
  DMat4 result = world_from_local;
  result[3] -= glm::dvec4(origin, 0.0);
  return result;
}

/// Whether an instance may have this transform in floats: its axes span a volume, and neither it
/// nor its inverse overflows.
bool is_invertible(const DMat4& matrix) {
  constexpr double flattest = 1e-6;
  constexpr double largest = 1e15;
  const DMat3 linear(matrix);
  double box = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = glm::length(linear[axis]);
    if (!(length > 1.0 / largest && length < largest)) {
      return false;
    }
    box *= length;
  }
  return std::abs(glm::determinant(linear)) > flattest * box &&
         glm::length(DVec3(matrix[3])) < largest;
}

std::size_t triangle_count(const LocalMesh& meshes) {
  std::size_t count = 0;
  for (const Mesh& mesh : meshes) {
    count += mesh.triangles.size();
  }
  return count;
}

/// The node's name, else the mesh's.
std::string object_name(const GltfModel& model, std::size_t mesh, const Placement& placement) {
  const std::string& name = model.nodes[static_cast<std::size_t>(placement.node)].name;
  return sanitised(name.empty() ? model.meshes[mesh].name : name);
}

/// A transform can flatten a triangle.
void mend_after_transform(Mesh& mesh, const std::string& place, Warnings& warnings) {
  warnings.add("triangles that their node's transform leaves without area are dropped", place,
               drop_degenerate_triangles(mesh));
  repair_normals(mesh);
  for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
    Vec4& tangent = mesh.tangents[i];
    if (!is_finite(Vec3(tangent))) {
      const Vec3 normal = mesh.normals.empty() ? Vec3(0.0F, 1.0F, 0.0F) : mesh.normals[i];
      tangent = Vec4(Frame(normal).tangent, tangent.w);
    }
  }
}

class MeshPlacer {
 public:
  MeshPlacer(Scene& scene, const GltfModel& model, Placing placing, MemoryBudget& budget,
             Warnings& warnings)
      : scene_(scene), model_(model), placing_(placing), budget_(budget), warnings_(warnings) {}

  void add(std::size_t index, LocalMesh meshes, const std::vector<Placement>& placements) {
    if (placements.empty() || meshes.empty()) {
      return;
    }
    constexpr std::size_t max_added = 65536;
    constexpr std::size_t max_added_by_all = std::size_t{1} << 22;
    const std::size_t added = (placements.size() - 1) * triangle_count(meshes);
    if (placing_ == Placing::instances || added > max_added || added + added_ > max_added_by_all) {
      add_instances(index, std::move(meshes), placements);
      return;
    }
    added_ += added;
    budget_.take((placements.size() - 1) * bytes_of_all(meshes), place_of(index));
    for (std::size_t i = 0; i + 1 < placements.size(); ++i) {
      add_copy(index, meshes, placements[i]);
    }
    add_copy(index, std::move(meshes), placements.back());
  }

 private:
  static std::string place_of(std::size_t index) { return fmt::format("meshes[{}]", index); }

  static std::size_t bytes_of_all(const LocalMesh& meshes) {
    std::size_t bytes = 0;
    for (const Mesh& mesh : meshes) {
      bytes += bytes_of(mesh);
    }
    return bytes;
  }

  void add_copy(std::size_t index, LocalMesh meshes, const Placement& placement) {
    for (Mesh& mesh : meshes) {
      throw_if_work_stopped();
      mesh.name = object_name(model_, index, placement);
      transform(mesh, seen_from(scene_.origin, placement.world_from_local));
      mend_after_transform(mesh, place_of(index), warnings_);
      if (!mesh.triangles.empty()) {
        scene_.meshes.push_back(std::move(mesh));
      }
    }
  }

  void add_instances(std::size_t index, LocalMesh meshes, std::vector<Placement> placements) {
    const auto flattened = std::stable_partition(
        placements.begin(), placements.end(), [&](const Placement& placement) {
          return is_invertible(seen_from(scene_.origin, placement.world_from_local));
        });
    const auto instances = static_cast<std::size_t>(flattened - placements.begin());
    budget_.take(instances * meshes.size() * sizeof(Instance) +
                     (placements.size() - instances) * bytes_of_all(meshes),
                 place_of(index));
    for (auto placement = flattened; placement != placements.end(); ++placement) {
      add_copy(index, meshes, *placement);
    }
    for (auto placement = placements.begin(); placement != flattened; ++placement) {
      const Mat4 world_from_local(seen_from(scene_.origin, placement->world_from_local));
      for (std::size_t i = 0; i < meshes.size(); ++i) {
        scene_.instances.push_back(
            {.name = object_name(model_, index, *placement),
             .prototype = static_cast<std::uint32_t>(scene_.prototypes.size() + i),
             .world_from_local = world_from_local});
      }
    }
    for (std::size_t i = 0; i < meshes.size() && instances > 0; ++i) {
      Mesh& mesh = meshes[i];
      mesh.name = sanitised(model_.meshes[index].name);
      scene_.prototypes.push_back(std::move(mesh));
    }
  }

  Scene& scene_;
  const GltfModel& model_;
  Placing placing_;
  MemoryBudget& budget_;
  Warnings& warnings_;
  std::size_t added_ = 0;  ///< triangles added by copies, beyond one of each mesh
};

}  // namespace

DVec3 choose_origin(const std::vector<LocalMesh>& meshes,
                    const std::vector<std::vector<Placement>>& placements) {
  DBounds world;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const DBounds local = bounds_of(meshes[i]);
    for (std::size_t k = 0; k < placements[i].size() && !local.is_empty(); ++k) {
      include(world, local, placements[i][k].world_from_local);
    }
  }
  return world.is_empty() ? DVec3(0.0) : origin_for(world.lower, world.upper);
}

void add_meshes(Scene& scene, std::vector<LocalMesh> meshes, const PlacedNodes& nodes,
                const GltfModel& model, Placing placing, MemoryBudget& budget, Warnings& warnings) {
  MeshPlacer placer(scene, model, placing, budget, warnings);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    placer.add(i, std::move(meshes[i]), nodes.meshes[i]);
  }
}

}  // namespace foveola
