#include "scenes/builtin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/files/digest.h"
#include "renderer/scene/load_scene.h"
#include "renderer/trace/rays/ray_scene.h"
#include "scenes/descriptor_search.h"

namespace foveola::scenes {
namespace {

/// Directions spread evenly over the sphere (spherical Fibonacci points).
std::vector<Vec3> even_directions(int count) {
  std::vector<Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double azimuth = 2.0 * std::numbers::pi * i / std::numbers::phi;
    const double r = std::sqrt(1.0 - y * y);
    directions.emplace_back(r * std::cos(azimuth), y, r * std::sin(azimuth));
  }
  return directions;
}

/// The scene as the renderer reads it, but for holes in leaves.
class BuiltScene {
 public:
  explicit BuiltScene(const std::string& name) : read(load_opaque(name)) {}

  Hit first_hit(const Vec3& origin, const Vec3& direction) const {
    return rays_.closest_hit_of_any_opacity(Ray{.origin = origin, .direction = direction});
  }

  const Mesh& mesh_at(const Hit& hit) const { return read.mesh_of(hit.object); }

  bool shows_its_front(const Hit& hit, const Vec3& direction) const {
    const Mesh& mesh = mesh_at(hit);
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    const DVec3 corner(mesh.positions[a]);
    const DVec3 front =
        glm::cross(DVec3(mesh.positions[b]) - corner, DVec3(mesh.positions[c]) - corner);
    return glm::dot(front, DVec3(direction)) < 0.0 || read.materials[mesh.material].double_sided;
  }

  const Scene read;

 private:
  static Scene load_opaque(const std::string& name) {
    Scene scene = load_scene_file(builtin_file(name));
    for (Material& material : scene.materials) {
      material.alpha_mode = AlphaMode::opaque;
    }
    return scene;
  }

  RayScene rays_{read, Workers(1)};
};

/// Read once for what a test asks of it.
const BuiltScene& built(const std::string& name) {
  static std::map<std::string, BuiltScene> scenes;
  return scenes.try_emplace(name, name).first->second;
}

const Scene& scene(const std::string& name) { return built(name).read; }

class BuiltinScene : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Every, BuiltinScene, testing::ValuesIn(builtin_names()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// What the generators made (see scenes/README.md).
struct Made {
  std::size_t triangles = 0;
  std::size_t emissive_triangles = 0;
  std::size_t objects = 0;
};
const std::map<std::string, Made> made = {{"arcade", {352'380, 0, 105}},
                                          {"church", {142'621, 3'253, 133}},
                                          {"meeting-room", {318'108, 232, 216}},
                                          {"schoolroom", {685'504, 4'368, 235}},
                                          {"studio-car", {621'596, 7'704, 167}}};

/// Compression loses nothing that a picture's mean could hide: a coarse grid makes small triangles
/// vanish.
void expect_all_that_was_made(const std::string& name) {
  const Scene& loaded = scene(name);
  EXPECT_THAT(loaded.warnings, testing::IsEmpty());
  EXPECT_EQ(loaded.sha256, find_descriptor(name).value().sha256);
  EXPECT_EQ(loaded.origin, DVec3(0.0));
  EXPECT_EQ(loaded.triangle_count(), made.at(name).triangles);
  std::size_t emissive_triangles = 0;
  for (const Mesh& mesh : loaded.meshes) {
    emissive_triangles += loaded.materials[mesh.material].is_emissive() ? mesh.triangles.size() : 0;
  }
  EXPECT_EQ(emissive_triangles, made.at(name).emissive_triangles);
  EXPECT_EQ(loaded.object_count(), made.at(name).objects);
}

/// Positions of 16 bits turn slivers of less than a square millimetre.
void expect_triangles_with_front_normals(const std::string& name) {
  constexpr double sliver_m2 = 1e-6;
  std::size_t faults = 0;
  for (const Mesh& mesh : scene(name).meshes) {
    for (const auto& triangle : mesh.triangles) {
      const DVec3 a(mesh.positions[triangle[0]]);
      const DVec3 across = glm::cross(DVec3(mesh.positions[triangle[1]]) - a,
                                      DVec3(mesh.positions[triangle[2]]) - a);
      faults += glm::length(across) > 0.0 ? 0 : 1;
      for (const std::uint32_t corner : triangle) {
        const DVec3 normal(mesh.normals[corner]);
        faults += std::abs(glm::length(normal) - 1.0) < 1e-5 ? 0 : 1;
        faults += glm::dot(normal, across) > 0.0 || glm::length(across) < 2.0 * sliver_m2 ? 0 : 1;
      }
    }
  }
  EXPECT_EQ(faults, 0U);
}

/// What it takes to have an inside.
struct Hull {
  std::size_t faulty_edges = 0;  ///< that are not passed exactly once in each direction
  double volume_m3 = 0.0;        ///< positive if the front faces look out
};

/// Of the object, which has a mesh for each of its materials.
Hull hull_of(const Scene& scene, const std::string& object) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, std::array<int, 2>> passes;
  const auto point = [](const Vec3& p) { return Point(p.x, p.y, p.z); };
  Hull hull;
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.name != object) {
      continue;
    }
    for (const auto& triangle : mesh.triangles) {
      std::array<DVec3, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = mesh.positions[triangle[i]];
        const Point from = point(mesh.positions[triangle[i]]);
        const Point to = point(mesh.positions[triangle[(i + 1) % 3]]);
        from < to ? ++passes[{from, to}][0] : ++passes[{to, from}][1];
      }
      hull.volume_m3 += glm::dot(corners[0], glm::cross(corners[1], corners[2])) / 6.0;
    }
  }
  hull.faulty_edges =
      static_cast<std::size_t>(std::count_if(passes.begin(), passes.end(), [](const auto& edge) {
        return edge.second != std::array{1, 1};
      }));
  return hull;
}

/// Solid things, which have an inside. Others stand open where nobody sees it: columns in the
/// floor, cloth, leaves, pages, glass.
const std::map<std::string, std::vector<std::string>> solids = {
    {"arcade", {"Outer walls", "Roof", "Plinth", "Urn", "Bench", "Steps", "Corner piers"}},
    {"church",
     {"Organ", "Pew 1", "Pew 12", "Rood cross", "Confessional", "Chandelier", "West door",
      "Choir steps", "Votive candles"}},
    {"meeting-room", {"Table", "Cabinet", "Conference phone", "Waste bin", "Door", "Jugs"}},
    {"schoolroom",
     {"Walls", "Desk 1", "Chairs 12", "Teacher's desk", "Teacher's chair", "Bookshelves", "Globe",
      "Microscope", "Skeleton", "Coats", "School bags", "Radiators", "Window frames"}},
    {"studio-car",
     {"Car seats", "Car mirrors", "Steering wheel", "Tool trolley", "Workbench", "Flight case 1",
      "Stool", "Ladder", "Truss", "Fire extinguisher"}}};

void expect_closed_solids(const std::string& name) {
  for (const std::string& solid : solids.at(name)) {
    const Hull hull = hull_of(scene(name), solid);
    EXPECT_EQ(hull.faulty_edges, 0U) << solid;
    EXPECT_GT(hull.volume_m3, 0.0) << solid;
  }
}

void expect_descriptors_camera(const std::string& name) {
  const Descriptor descriptor = find_descriptor(name).value();
  const CameraView& camera = scene(name).cameras.at(0);
  EXPECT_EQ(descriptor.source.camera_position, camera.position);
  EXPECT_NEAR(descriptor.source.heading.azimuth_rad, camera.heading.azimuth_rad, 1e-6);
  EXPECT_NEAR(descriptor.source.heading.elevation_rad, camera.heading.elevation_rad, 1e-6);
}

void expect_visible_objects_of_interest(const std::string& name) {
  const SceneSource source = find_descriptor(name).value().source;
  const Vec3 camera = source.camera_position.value();
  EXPECT_GE(source.objects.size(), 3U);
  for (const ObjectOfInterest& object : source.objects) {
    SCOPED_TRACE(object.name);
    const Vec3 towards = object.position - camera;
    EXPECT_LT(degrees(angle_between(towards, direction_from(source.heading))), 45.0);
    EXPECT_GE(object.radius_deg, 4.0F);
    EXPECT_LE(object.radius_deg, 12.0F);
    const Hit hit = built(name).first_hit(camera, glm::normalize(towards));
    ASSERT_FALSE(hit.missed());
    EXPECT_EQ(built(name).mesh_at(hit).name, object.name);
    const double distance = glm::length(towards);
    EXPECT_LT(std::abs(hit.t - distance), distance * std::tan(radians(object.radius_deg)));
    for (const ObjectOfInterest& other : source.objects) {
      if (&other != &object) {
        EXPECT_GT(degrees(angle_between(towards, other.position - camera)),
                  std::max(object.radius_deg, other.radius_deg));
      }
    }
  }
}

void expect_front_faces_around(const std::string& name) {
  const bool has_open_sky = name == "arcade" || name == "studio-car";
  const Vec3 camera = scene(name).cameras.at(0).position;
  int sky = 0;
  for (const Vec3& direction : even_directions(600)) {
    const Hit hit = built(name).first_hit(camera, direction);
    if (hit.missed()) {
      EXPECT_TRUE(has_open_sky && direction.y > 0.3) << "a hole where y = " << direction.y;
      ++sky;
      continue;
    }
    EXPECT_TRUE(built(name).shows_its_front(hit, direction)) << built(name).mesh_at(hit).name;
  }
  EXPECT_EQ(sky > 0, has_open_sky);
}

TEST_P(BuiltinScene, IsSound) {
  expect_all_that_was_made(GetParam());
  expect_triangles_with_front_normals(GetParam());
  expect_closed_solids(GetParam());
  expect_descriptors_camera(GetParam());
  expect_visible_objects_of_interest(GetParam());
  expect_front_faces_around(GetParam());
}

}  // namespace
}  // namespace foveola::scenes
