#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/stability/checks.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/estimate.h"
#include "renderer/stability/furnished_room.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

constexpr std::array<float, 9> scales{1e-3F, 1e-2F, 1e-1F, 1e1F, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F};

/// A direction along no axis, so that all three coordinates are large.
const DVec3 away = glm::normalize(DVec3(1.0, -0.7, 0.8));

/// Moving vertices by a multiple of the scene's size rounds them, which changes the scene by this
/// much relative to its size: half a unit in the last place for each of a few vertices.
double rounding_of(double distance) { return 4.0 * distance * 0x1p-24; }

/// A copy of the room, and its viewpoint.
struct Copy {
  std::string name;
  Scene scene;
  Vec3 viewpoint;
  double rounding_allowance = 0.0;
};

Copy baked_copy(float scale, double distance) {
  const Vec3 place(scale * room_size_m * distance * away);
  Copy copy{.name = distance > 0.0 ? fmt::format("vertices moved by {:g} of its size", distance)
                                   : fmt::format("scale {:g}", scale),
            .scene = baked(furnished_room(), scale, place),
            .rounding_allowance = rounding_of(distance)};
  copy.viewpoint = copy.scene.from_file(DVec3(scale * room_viewpoint) + DVec3(place));
  return copy;
}

Copy node_copy(float scale, double distance) {
  const DVec3 place = static_cast<double>(scale * room_size_m) * distance * away;
  Copy copy{.name = fmt::format("scale {:g}, node moved by {:g} of its size", scale, distance),
            .scene = through_gltf(baked(furnished_room(), scale, Vec3(0.0F)),
                                  scale * room_viewpoint, place),
            .viewpoint = Vec3(0.0F)};
  copy.viewpoint = copy.scene.cameras.front().position;
  return copy;
}

/// Compares copies of the room with the room itself.
class RoomPictures {
 public:
  explicit RoomPictures(const StabilityRun& run) : run_(run) {
    const Scene room = furnished_room();
    reference_ = render(room, room_viewpoint);
  }

  StabilityFigure difference(const Copy& copy) {
    return picture_difference(copy.name, render(copy.scene, copy.viewpoint), reference_,
                              copy.rounding_allowance);
  }

 private:
  /// Every picture has its own seed.
  std::vector<RadianceEstimate> render(const Scene& scene, const Vec3& viewpoint) {
    const PathTracer tracer(scene, run_.workers);
    return render_blocks(tracer, viewpoint, {.seed = ++pictures_}, run_);
  }

  const StabilityRun& run_;
  std::uint32_t pictures_ = 0;
  std::vector<RadianceEstimate> reference_;
};

/// A floor of many triangles under a rectangle of radiance 1: it must receive all of the light.
StabilityFigure lit_floor(float scale, double distance, const StabilityRun& run) {
  Scene scene;
  scene.materials = {matte(Rgb(0.8F)), lamp(Rgb(1.0F))};
  scene.meshes = {tessellated_quad(Vec3(-1, 0, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), 99, 0),
                  quad(Vec3(-0.5F, 1, -0.5F), Vec3(1, 0, 0), Vec3(0, 0, 1), 1)};
  const Vec3 place(scale * room_size_m * distance * away);
  const Scene copy = baked(scene, scale, place);
  const PathTracer tracer(copy, run.workers);
  const double expected = 4.0 * 0.8 * corner_rectangle_form_factor(0.5, 0.5, 1.0);
  const Measurement look =
      single_ray(copy.from_file(DVec3(scale * Vec3(-1.0F, 0.8F, 0.0F)) + DVec3(place)),
                 Vec3(1.0F, -0.8F, 0.0F), 1, expected);
  return deviation(fmt::format("floor, scale {:g}, moved by {:g} of its size", scale, distance),
                   measure(tracer, look, run), DVec3(expected), 2e-5 + rounding_of(distance),
                   run.effort.tolerance);
}

/// A ball of flat triangles under a constant sky: each sees all of the sky above its plane.
StabilityFigure lit_ball(float scale, double distance, const StabilityRun& run) {
  Scene scene;
  scene.materials = {matte(Rgb(0.8F))};
  scene.meshes = {flat_shaded(inside_out(inward_sphere(1.0F, 4, 0)))};
  scene.environment = constant_environment(1.0F);
  const Vec3 place(scale * room_size_m * distance * away);
  const Scene copy = baked(scene, scale, place);
  const PathTracer tracer(copy, run.workers);
  const Measurement look{.viewpoint = copy.from_file(DVec3(scale * Vec3(0, 0, 2)) + DVec3(place)),
                         .direction =
                             [](const Vec2& u) {
                               const float sine = 0.45F * std::sqrt(u.x);
                               const float turn = 2.0F * std::numbers::pi_v<float> * u.y;
                               return Vec3(sine * std::cos(turn), sine * std::sin(turn),
                                           -std::sqrt(1.0F - sine * sine));
                             },
                         .max_depth = 4,
                         .expected = 0.8};
  return deviation(fmt::format("ball, scale {:g}, moved by {:g} of its size", scale, distance),
                   measure(tracer, look, run), DVec3(0.8), 2e-5, run.effort.tolerance);
}

}  // namespace

std::vector<StabilityFigure> check_scale_and_place(const StabilityRun& run) {
  constexpr std::array<double, 3> baked_distances{10.0, 100.0, 1000.0};
  constexpr std::array<double, 3> node_distances{10.0, 1000.0, 1e5};
  constexpr std::array<float, 3> node_scales{1e-3F, 1.0F, 1e3F};
  constexpr double steps = 36.0;
  int done = 0;
  const auto advance = [&] { run.progress(++done / steps); };

  RoomPictures pictures(run);
  std::vector<StabilityFigure> scaled;
  std::vector<StabilityFigure> unshadowed;
  for (const float scale : scales) {
    scaled.push_back(pictures.difference(baked_copy(scale, 0.0)));
    unshadowed.push_back(lit_floor(scale, 0.0, run));
    unshadowed.push_back(lit_ball(scale, 0.0, run));
    advance();
  }
  std::vector<StabilityFigure> moved;
  for (const double distance : baked_distances) {
    moved.push_back(pictures.difference(baked_copy(1.0F, distance)));
    unshadowed.push_back(lit_floor(1.0F, distance, run));
    unshadowed.push_back(lit_ball(1.0F, distance, run));
    advance();
  }
  std::vector<StabilityFigure> moved_by_node;
  for (const float scale : node_scales) {
    for (const double distance : node_distances) {
      moved_by_node.push_back(pictures.difference(node_copy(scale, distance)));
      advance();
    }
  }
  return {worst_of("room scaled by 1e-3 to 1e6: picture", scaled),
          worst_of("room moved by vertices, up to 1e3 of its size: picture", moved),
          worst_of("room moved by nodes, up to 1e5 of its size: picture", moved_by_node),
          worst_of("surfaces shadowing themselves, at these scales and places", unshadowed)};
}

}  // namespace foveola
