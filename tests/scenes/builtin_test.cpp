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

#include "renderer/base/digest.h"
#include "renderer/base/error.h"
#include "renderer/scene/load_scene.h"
#include "scenes/builtin_files.h"
#include "scenes/descriptor_search.h"
#include "scenes/modelling/glb_writer.h"
#include "tests/scenes/environment.h"
#include "tests/scenes/glb.h"

namespace foveola::scenes {
namespace {

using testing::HasSubstr;

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  std::string object;
  bool from_the_front = false;
};

/// Where a ray hits a triangle (Moller and Trumbore 1997), without back-face culling.
std::optional<double> distance_to(const DVec3& origin, const DVec3& direction, const DVec3& a,
                                  const DVec3& b, const DVec3& c) {
  const DVec3 p = glm::cross(direction, c - a);
  const double determinant = glm::dot(b - a, p);
  if (determinant == 0.0) {
    return std::nullopt;
  }
  const DVec3 from_a = origin - a;
  const double u = glm::dot(from_a, p) / determinant;
  const DVec3 q = glm::cross(from_a, b - a);
  const double v = glm::dot(direction, q) / determinant;
  const double t = glm::dot(c - a, q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-9 ? std::optional(t) : std::nullopt;
}

/// Finds the nearest triangle along a ray, leaves counting as opaque.
class RayCaster {
 public:
  explicit RayCaster(const Model& model) : model_(model) {
    for (const Object& object : model.objects) {
      for (const Surface& surface : object.surfaces) {
        Vec3 lower = surface.positions.front();
        Vec3 upper = lower;
        for (const Vec3& position : surface.positions) {
          lower = glm::min(lower, position);
          upper = glm::max(upper, position);
        }
        balls_.push_back({&object, &surface, 0.5 * (DVec3(lower) + DVec3(upper)),
                          0.5 * glm::length(DVec3(upper) - DVec3(lower)) + 1e-6});
      }
    }
  }

  std::optional<Hit> first_hit(const DVec3& origin, const DVec3& direction) const {
    Hit nearest;
    for (const Ball& ball : balls_) {
      const DVec3 to_center = ball.center - origin;
      if (glm::length(glm::cross(direction, to_center)) <= ball.radius) {
        find_nearer(ball, origin, direction, nearest);
      }
    }
    return std::isfinite(nearest.distance) ? std::optional(nearest) : std::nullopt;
  }

 private:
  /// A surface and what encloses it.
  struct Ball {
    const Object* object;
    const Surface* surface;
    DVec3 center;
    double radius;
  };

  void find_nearer(const Ball& ball, const DVec3& origin, const DVec3& direction,
                   Hit& nearest) const {
    const Surface& surface = *ball.surface;
    for (const auto& [a, b, c] : surface.triangles) {
      const DVec3 pa(surface.positions[a]);
      const DVec3 pb(surface.positions[b]);
      const DVec3 pc(surface.positions[c]);
      const auto distance = distance_to(origin, direction, pa, pb, pc);
      if (distance && *distance < nearest.distance) {
        const bool front = glm::dot(glm::cross(pb - pa, pc - pa), direction) < 0.0;
        nearest = {*distance, ball.object->name,
                   front || model_.materials[surface.material].double_sided};
      }
    }
  }

  const Model& model_;
  std::vector<Ball> balls_;
};

/// Directions spread evenly over the sphere (spherical Fibonacci points).
std::vector<DVec3> even_directions(int count) {
  std::vector<DVec3> directions;
  for (int i = 0; i < count; ++i) {
    const double y = 1.0 - (2.0 * i + 1.0) / count;
    const double azimuth = 2.0 * std::numbers::pi * i / std::numbers::phi;
    const double r = std::sqrt(1.0 - y * y);
    directions.emplace_back(r * std::cos(azimuth), y, r * std::sin(azimuth));
  }
  return directions;
}

/// The scene, made once for what a test asks of it.
const Model& scene(const std::string& name) {
  static std::map<std::string, Model> scenes;
  const auto [entry, is_new] = scenes.try_emplace(name);
  if (is_new) {
    entry->second = make_builtin(name);
  }
  return entry->second;
}

class BuiltinScene : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Every, BuiltinScene, testing::ValuesIn(builtin_names()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Records name scenes by their hash. Whoever changes a scene on purpose writes its new hash, which
/// `foveola scene make` prints, into the descriptor.
TEST_P(BuiltinScene, HasTheStoredHashEveryTime) {
  const std::string stored = find_descriptor(GetParam()).value().sha256;
  EXPECT_EQ(sha256(glb_from(scene(GetParam()))), stored);
  EXPECT_EQ(sha256(glb_from(make_builtin(GetParam()))), stored);
}

/// The same things in the same places, but not the same.
TEST_P(BuiltinScene, HasVariants) {
  const Model& usual = scene(GetParam());
  const Model variant = make_builtin(GetParam(), 7);
  EXPECT_NE(sha256(glb_from(variant)), sha256(glb_from(usual)));
  ASSERT_EQ(variant.objects.size(), usual.objects.size());
  for (std::size_t i = 0; i < usual.objects.size(); ++i) {
    EXPECT_EQ(variant.objects[i].name, usual.objects[i].name);
  }
  EXPECT_EQ(variant.materials.size(), usual.materials.size());
  EXPECT_EQ(variant.cameras.at(0).position, usual.cameras.at(0).position);
}

/// The sizes of the published study's scenes, each under its counterpart's name.
const std::map<std::string, std::size_t> triangles_of_originals = {{"arcade", 260'000},
                                                                   {"church", 80'000},
                                                                   {"meeting-room", 300'000},
                                                                   {"schoolroom", 600'000},
                                                                   {"studio-car", 400'000}};

void expect_order_of_size_of_original(const std::string& name) {
  const std::size_t triangles = scene(name).triangle_count();
  const std::size_t original = triangles_of_originals.at(name);
  EXPECT_GE(triangles, original / 2);
  EXPECT_LE(triangles, original * 2);
}

void expect_accessors_inside_buffer_views(const std::string& name) {
  const Glb glb = taken_apart(glb_from(scene(name)));
  for (const nlohmann::json& view : glb.json.at("bufferViews")) {
    EXPECT_EQ(view.at("byteOffset").get<std::size_t>() % 4, 0U);
    EXPECT_LE(view.at("byteOffset").get<std::size_t>() + view.at("byteLength").get<std::size_t>(),
              glb.binary.size());
  }
  for (const nlohmann::json& mesh : glb.json.at("meshes")) {
    for (const nlohmann::json& primitive : mesh.at("primitives")) {
      const nlohmann::json& attributes = primitive.at("attributes");
      const auto positions = items_of<float>(glb, attributes.at("POSITION"), 3);
      const auto normals = items_of<float>(glb, attributes.at("NORMAL"), 3);
      EXPECT_EQ(normals.size(), positions.size());
      if (attributes.contains("TEXCOORD_0")) {
        const auto uvs = items_of<float>(glb, attributes.at("TEXCOORD_0"), 2);
        EXPECT_EQ(uvs.size() / 2, positions.size() / 3);
      }
      const auto indices = indices_of(glb, primitive.at("indices"));
      EXPECT_EQ(indices.size() % 3, 0U);
      EXPECT_LT(*std::max_element(indices.begin(), indices.end()), positions.size() / 3);
      EXPECT_LT(primitive.at("material").get<std::size_t>(), glb.json.at("materials").size());
    }
  }
}

void expect_triangles_with_front_normals(const std::string& name) {
  std::size_t faults = 0;
  for (const Object& object : scene(name).objects) {
    for (const Surface& surface : object.surfaces) {
      for (const auto& triangle : surface.triangles) {
        const DVec3 a(surface.positions[triangle[0]]);
        const DVec3 across = glm::cross(DVec3(surface.positions[triangle[1]]) - a,
                                        DVec3(surface.positions[triangle[2]]) - a);
        faults += glm::length(across) > 0.0 ? 0 : 1;
        for (const std::uint32_t corner : triangle) {
          const DVec3 normal(surface.normals[corner]);
          faults += std::abs(glm::length(normal) - 1.0) < 1e-5 ? 0 : 1;
          faults += glm::dot(normal, across) > 0.0 ? 0 : 1;
        }
      }
    }
  }
  EXPECT_EQ(faults, 0U);
}

/// The renderer sees what was modelled, and has nothing to complain of.
void expect_loads_as_made(const std::string& name) {
  const Model& model = scene(name);
  const TemporaryFolder folder;
  const foveola::Scene loaded = load_scene_file(folder.write(name + ".glb", glb_from(model)));
  EXPECT_THAT(loaded.warnings, testing::IsEmpty());
  EXPECT_EQ(loaded.origin, DVec3(0.0));
  EXPECT_EQ(loaded.triangle_count(), model.triangle_count());
  EXPECT_EQ(loaded.materials.size(), model.materials.size());
  ASSERT_EQ(loaded.cameras.size(), 1U);
  EXPECT_EQ(loaded.cameras[0].position, model.cameras[0].position);
  std::size_t mesh = 0;
  for (const Object& object : model.objects) {
    for (const Surface& surface : object.surfaces) {
      ASSERT_LT(mesh, loaded.meshes.size());
      EXPECT_EQ(loaded.meshes[mesh].name, object.name);
      EXPECT_EQ(loaded.meshes[mesh].positions, surface.positions);
      EXPECT_EQ(loaded.meshes[mesh].triangles.size(), surface.triangles.size());
      EXPECT_EQ(loaded.materials[loaded.meshes[mesh].material].name,
                model.materials[surface.material].name);
      ++mesh;
    }
  }
  EXPECT_EQ(mesh, loaded.meshes.size());
}

/// What it takes to have an inside.
struct Hull {
  std::size_t faulty_edges = 0;  ///< that are not passed exactly once in each direction
  double volume_m3 = 0.0;        ///< positive if the front faces look out
};

Hull hull_of(const Object& object) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, std::array<int, 2>> passes;
  const auto point = [](const Vec3& p) { return Point(p.x, p.y, p.z); };
  Hull hull;
  for (const Surface& surface : object.surfaces) {
    for (const auto& triangle : surface.triangles) {
      std::array<DVec3, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = surface.positions[triangle[i]];
        const Point from = point(surface.positions[triangle[i]]);
        const Point to = point(surface.positions[triangle[(i + 1) % 3]]);
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
  const std::vector<Object>& objects = scene(name).objects;
  for (const std::string& solid_name : solids.at(name)) {
    const auto solid = std::find_if(objects.begin(), objects.end(), [&](const Object& object) {
      return object.name == solid_name;
    });
    ASSERT_NE(solid, objects.end()) << solid_name;
    const Hull hull = hull_of(*solid);
    EXPECT_EQ(hull.faulty_edges, 0U) << solid_name;
    EXPECT_GT(hull.volume_m3, 0.0) << solid_name;
  }
}

void expect_descriptors_camera(const std::string& name) {
  const Descriptor descriptor = find_descriptor(name).value();
  const Camera& camera = scene(name).cameras.at(0);
  EXPECT_EQ(descriptor.source.camera_position, camera.position);
  EXPECT_DOUBLE_EQ(descriptor.source.heading.azimuth_rad, camera.heading.azimuth_rad);
  EXPECT_DOUBLE_EQ(descriptor.source.heading.elevation_rad, camera.heading.elevation_rad);
}

void expect_visible_objects_of_interest(const std::string& name) {
  const SceneSource source = find_descriptor(name).value().source;
  const RayCaster caster(scene(name));
  const Vec3 camera = source.camera_position.value();
  EXPECT_GE(source.objects.size(), 3U);
  for (const ObjectOfInterest& object : source.objects) {
    SCOPED_TRACE(object.name);
    const Vec3 towards = object.position - camera;
    EXPECT_LT(degrees(angle_between(towards, direction_from(source.heading))), 45.0);
    EXPECT_GE(object.radius_deg, 4.0F);
    EXPECT_LE(object.radius_deg, 12.0F);
    const auto hit = caster.first_hit(DVec3(camera), glm::normalize(DVec3(towards)));
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->object, object.name);
    const double distance = glm::length(towards);
    EXPECT_LT(std::abs(hit->distance - distance), distance * std::tan(radians(object.radius_deg)));
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
  const Model& model = scene(name);
  const RayCaster caster(model);
  const DVec3 camera(model.cameras.at(0).position);
  int sky = 0;
  for (const DVec3& direction : even_directions(600)) {
    const auto hit = caster.first_hit(camera, direction);
    if (!hit) {
      EXPECT_TRUE(has_open_sky && direction.y > 0.3) << "a hole where y = " << direction.y;
      ++sky;
      continue;
    }
    EXPECT_TRUE(hit->from_the_front) << hit->object;
  }
  EXPECT_EQ(sky > 0, has_open_sky);
}

/// One test of much, since each is a process of its own, which has to make the scene.
TEST_P(BuiltinScene, IsSound) {
  expect_order_of_size_of_original(GetParam());
  expect_accessors_inside_buffer_views(GetParam());
  expect_triangles_with_front_normals(GetParam());
  expect_loads_as_made(GetParam());
  expect_closed_solids(GetParam());
  expect_descriptors_camera(GetParam());
  expect_visible_objects_of_interest(GetParam());
  expect_front_faces_around(GetParam());
}

TEST(Builtin, UnknownNameIsRefused) {
  try {
    make_builtin("castle");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("arcade, church, meeting-room, schoolroom, studio-car"));
  }
}

}  // namespace
}  // namespace foveola::scenes
