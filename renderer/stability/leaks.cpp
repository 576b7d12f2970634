#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/base/numbers/random.h"
#include "renderer/scene/prepare/rebase.h"
#include "renderer/stability/checks.h"
#include "renderer/stability/estimate.h"
#include "renderer/stability/furnished_room.h"
#include "renderer/stability/shapes.h"
#include "renderer/trace/paths/path_tracer.h"

namespace foveola {
namespace {

/// Light from outside is blue; light inside is red.
const Rgb outside(0.0F, 0.0F, 1.0F);
const Rgb inside(1.0F, 0.0F, 0.0F);

struct Room {
  std::string name;
  Scene scene;
  /// A point inside it, well off its walls.
  std::function<Vec3(Pcg32&)> viewpoint;
};

Scene under_blue_sky() {
  Scene scene;
  scene.materials = {matte(Rgb(0.9F)), lamp(inside, true), lamp(outside, true)};
  scene.environment = constant_environment(1.0F);
  scene.environment->radiance = outside;
  return scene;
}

float between(Pcg32& random, float lower, float upper) {
  return lower + (upper - lower) * static_cast<float>(random.uniform());
}

/// A point of the box at least a hundredth of its half side away from the walls.
Vec3 point_in_box(Pcg32& random) {
  const float x = between(random, -0.99F, 0.99F);
  const float y = between(random, -0.99F, 0.99F);
  const float z = between(random, -0.99F, 0.99F);
  return {x, y, z};
}

Room box_of_many_triangles() {
  Room room{.name = "box of 50000 triangles", .scene = under_blue_sky(), .viewpoint = point_in_box};
  room.scene.meshes = {tessellated_inward_box(Vec3(0.0F), 1.0F, 64, 0),
                       quad(Vec3(-0.3F, 0.9F, -0.3F), Vec3(0.6F, 0, 0), Vec3(0, 0, 0.6F), 1)};
  return room;
}

/// At its edges a point moved off one wall comes close to the next.
Room tetrahedron_of_sharp_edges() {
  Room room{.name = "tetrahedron of 16000 triangles",
            .scene = under_blue_sky(),
            .viewpoint = [](Pcg32& random) {
              const auto along = [&] { return 0.3F * between(random, -1.0F, 1.0F); };
              const float x = along();
              const float y = along();
              return Vec3(x, y, along());
            }};
  room.scene.meshes = {inward_tetrahedron(2.0F, 64, 0)};
  return room;
}

/// The sheet sticks out of the box, so that it meets the walls without a gap; behind it is a lamp.
/// Nearer to their intersection than a ten-millionth of the room's size, below floats' resolution,
/// a point may count as behind the sheet.
Room room_behind_a_sheet() {
  Room room{.name = "room behind a sheet without thickness",
            .scene = under_blue_sky(),
            .viewpoint = [](Pcg32& random) {
              Vec3 point = point_in_box(random);
              point.x = std::min(point.x, -0.01F);
              return point;
            }};
  room.scene.meshes = {
      tessellated_inward_box(Vec3(0.0F), 1.0F, 16, 0),
      tessellated_quad(Vec3(0, -1.3F, -1.3F), Vec3(0, 2.6F, 0), Vec3(0, 0, 2.6F), 37, 0),
      quad(Vec3(0.1F, -0.9F, -0.9F), Vec3(0, 1.8F, 0), Vec3(0, 0, 1.8F), 2)};
  return room;
}

/// Its walls reflect light by their interpolated normals.
Room ball_of_smooth_mirrors() {
  Room room{.name = "ball of 1280 smooth-shaded mirrors",
            .scene = under_blue_sky(),
            .viewpoint = [](Pcg32& random) { return 0.5F * point_in_box(random); }};
  room.scene.materials[0] = metal(0.9F, 0.0F);
  room.scene.meshes = {inward_sphere(1.0F, 3, 0)};
  return room;
}

struct Placement {
  float scale = 1.0F;
  double distance = 0.0;      ///< in multiples of the room's size
  bool by_instances = false;  ///< not by its vertices
};
constexpr std::array<Placement, 9> placements{{{1.0F, 0.0},
                                               {1e-3F, 0.0},
                                               {1e6F, 0.0},
                                               {1.0F, 10.0},
                                               {1.0F, 100.0},
                                               {1.0F, 1000.0},
                                               {1.0F, 0.0, true},
                                               {1e6F, 0.0, true},
                                               {1.0F, 100.0, true}}};

std::string describe(const Placement& placement) {
  return fmt::format("at scale {:g}, moved by {:g} of its size{}", placement.scale,
                     placement.distance, placement.by_instances ? ", as instances" : "");
}

/// A rotated, scaled and moved room, with its paths.
class PlacedRoom {
 public:
  PlacedRoom(const Room& room, const Placement& placement, const Workers& workers)
      : room_(room),
        placement_(placement),
        turn_(glm::angleAxis(0.7F, glm::normalize(Vec3(1, 2, -1)))),
        place_(placement.scale * room_size_m * placement.distance *
               glm::normalize(DVec3(1.0, -0.7, 0.8))),
        scene_(room.scene) {
    if (placement.by_instances) {
      turn_into_instances();
    } else {
      for (Mesh& mesh : scene_.meshes) {
        mesh = placed(std::move(mesh), placement.scale, turn_, place_);
      }
    }
    rebase(scene_);  // as the loaders do
    tracer_.emplace(scene_, workers);
  }
  PlacedRoom(const PlacedRoom&) = delete;
  PlacedRoom& operator=(const PlacedRoom&) = delete;

  /// Number of `paths` paths in all directions that see the outside.
  std::uint64_t count(std::uint64_t paths, const StabilityRun& run) const {
    constexpr std::uint64_t paths_per_viewpoint = 1 << 14;
    Pcg32 random(11);
    std::uint64_t leaks = 0;
    for (std::uint64_t done = 0; done < paths && !run.stop.stop_requested();
         done += paths_per_viewpoint) {
      const Vec3 local = room_.viewpoint(random);
      const Vec3 viewpoint =
          scene_.from_file(DVec3(turn_ * (placement_.scale * local)) + DVec3(place_));
      leaks += count_from(viewpoint, std::min(paths_per_viewpoint, paths - done),
                          static_cast<std::uint32_t>(done / paths_per_viewpoint), run.workers);
    }
    return leaks;
  }

 private:
  void turn_into_instances() {
    const Mat4 moved = glm::translate(Mat4(1.0F), place_);
    const Mat4 turned = moved * glm::mat4_cast(turn_);
    const Mat4 world_from_local = glm::scale(turned, Vec3(placement_.scale));
    scene_.prototypes = std::exchange(scene_.meshes, {});
    for (std::uint32_t i = 0; i < scene_.prototypes.size(); ++i) {
      scene_.instances.push_back({.prototype = i, .world_from_local = world_from_local});
    }
  }

  std::uint64_t count_from(const Vec3& viewpoint, std::uint64_t paths, std::uint32_t seed,
                           const Workers& workers) const {
    const auto jobs = uniform_jobs(static_cast<std::uint32_t>(paths), seed);
    std::vector<Rgb> radiance(jobs.size());
    tracer_->trace(viewpoint, jobs, radiance, {.max_depth = 16, .seed = seed}, workers);
    // A NaN radiance counts as a leak, too.
    return static_cast<std::uint64_t>(
        std::ranges::count_if(radiance, [](const Rgb& value) { return !(value.b == 0.0F); }));
  }

  const Room& room_;
  Placement placement_;
  Quat turn_;
  Vec3 place_;
  Scene scene_;
  std::optional<PathTracer> tracer_;
};

}  // namespace

std::vector<StabilityFigure> check_leaks(const StabilityRun& run) {
  const std::vector<Room> rooms = {box_of_many_triangles(), tetrahedron_of_sharp_edges(),
                                   room_behind_a_sheet(), ball_of_smooth_mirrors()};
  const std::uint64_t paths_each =
      std::max<std::uint64_t>(1, run.effort.leak_paths / placements.size());
  std::vector<StabilityFigure> figures;
  double done = 0.0;
  for (const Room& room : rooms) {
    StabilityFigure figure{
        .name = "light leaks: " + room.name,
        .unit = fmt::format("of {} paths", paths_each * placements.size()),
        .details =
            "turned, at scales 1e-3 to 1e6, moved by up to 1e3 sizes, by their vertices "
            "or as instances"};
    for (const Placement& placement : placements) {
      const std::uint64_t leaks = PlacedRoom(room, placement, run.workers).count(paths_each, run);
      figure.measured += static_cast<double>(leaks);
      if (leaks > 0) {
        figure.details += fmt::format("; {} {}", leaks, describe(placement));
      }
      run.progress(++done / static_cast<double>(rooms.size() * placements.size()));
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace foveola
