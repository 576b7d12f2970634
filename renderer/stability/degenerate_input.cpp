#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "renderer/stability/checks.h"
#include "renderer/stability/estimate.h"
#include "renderer/stability/furnished_room.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

/// The furnished room's materials, and those that are added.
enum Paint : int { white = 0, shining = 4, black = 6, mirror, clear };

constexpr int triangles_without_area = 4;
constexpr int triangles_not_finite = 3;

Mesh loose_triangles(const std::vector<std::array<Vec3, 3>>& triangles, int material) {
  Mesh mesh;
  mesh.material = material;
  for (const std::array<Vec3, 3>& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// Triangles degenerate to points and lines, in the middle of the room.
Mesh without_area(int material) {
  const Vec3 p(0.0F, 0.25F, 0.5F);
  const Vec3 q(0.5F, 0.25F, 0.0F);
  return loose_triangles({{p, p, p}, {p, p, q}, {p, q, p}, {p, 0.5F * (p + q), q}}, material);
}

/// Triangles as long as the room and as wide as a few units in the last place, on its floor.
Mesh needles() {
  const float width = 4.0F * std::numeric_limits<float>::epsilon();
  return loose_triangles({{Vec3(-1, -1, 0), Vec3(1, -1, width), Vec3(1, -1, 0)},
                          {Vec3(0, -1, 1), Vec3(width, -1, -1), Vec3(0, -1, -1)},
                          {Vec3(-1, -1, 1), Vec3(1, -1, -1), Vec3(1 - width, -1, -1)}},
                         white);
}

Mesh not_finite() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return loose_triangles({{Vec3(nan, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                          {Vec3(0, 0, 0), Vec3(infinity, 0, 0), Vec3(0, 1, 0)},
                          {Vec3(0, 0, 0), Vec3(1, -infinity, nan), Vec3(0, 1, 0)}},
                         white);
}

/// The floor once more, in other triangles, with useless normals.
Mesh second_floor(const Vec3& normal) {
  Mesh floor = tessellated_quad(Vec3(-1, -1, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), 7, white);
  floor.normals.assign(floor.positions.size(), normal);
  return floor;
}

/// The furnished room with additions that must not change its picture.
Scene spoilt_room() {
  Scene scene = furnished_room();
  const Mesh floor = scene.meshes.front();
  scene.meshes.insert(
      scene.meshes.end(),
      {without_area(white), without_area(shining), needles(), not_finite(), floor,
       second_floor(Vec3(0.0F)), second_floor(Vec3(std::numeric_limits<float>::quiet_NaN()))});
  return scene;
}

/// The same room with balls of extreme materials, which do change it.
Scene extreme_room() {
  Scene scene = spoilt_room();
  scene.materials.insert(scene.materials.end(), {matte(Rgb(0.0F)), metal(1.0F, 0.0F), glass()});
  const Mesh ball = inside_out(inward_sphere(0.2F, 3, 0));
  for (const int material : {black, mirror, clear}) {
    scene.meshes.push_back(placed(ball, 1.0F, Quat(1, 0, 0, 0),
                                  Vec3(0.5F * static_cast<float>(material - mirror), 0.5F, -0.6F)));
    scene.meshes.back().material = material;
  }
  return scene;
}

std::uint64_t count_not_finite(const Scene& scene, const Vec3& viewpoint, const StabilityRun& run) {
  constexpr std::uint32_t pixels = 2048;
  const PathTracer tracer(scene, run.workers);
  const auto jobs =
      uniform_jobs(pixels * static_cast<std::uint32_t>(run.effort.picture_samples_per_pixel), 5);
  std::vector<Rgb> radiance(jobs.size());
  tracer.trace(viewpoint, jobs, radiance, {.seed = 5}, run.workers);
  return static_cast<std::uint64_t>(
      std::ranges::count_if(radiance, [](const Rgb& value) { return !is_finite(value); }));
}

StabilityFigure not_finite_figure(std::string name, const Scene& scene, const Vec3& viewpoint,
                                  const StabilityRun& run) {
  return {.name = std::move(name),
          .measured = static_cast<double>(count_not_finite(scene, viewpoint, run)),
          .bound = 0.0,
          .unit = fmt::format("of {} paths", 2048 * run.effort.picture_samples_per_pixel),
          .details =
              "triangles without area, needles, NaN vertices and normals, duplicates, overlaps, "
              "roughness 0, black"};
}

/// The warnings that the loader of extreme_room() in a file, with an albedo of 2, failed to give:
/// parts of their lines.
std::vector<std::string> warnings_missing(const Scene& loaded) {
  const std::array<std::string, 3> wanted{"without area", "invalid normals", "baseColorFactor"};
  std::vector<std::string> missing;
  for (const std::string& part : wanted) {
    const auto says_so = [&](const std::string& line) {
      return line.find(part) != std::string::npos;
    };
    if (std::ranges::none_of(loaded.warnings, says_so)) {
      missing.push_back(part);
    }
  }
  // Two meshes have triangles without area, one has triangles that are not finite.
  const std::string count = fmt::format("{}", 2 * triangles_without_area + triangles_not_finite);
  const auto counts = [&](const std::string& line) {
    return line.find(wanted[0]) != std::string::npos && line.find(count) != std::string::npos;
  };
  if (std::ranges::none_of(loaded.warnings, counts)) {
    missing.push_back("the number of dropped triangles, " + count);
  }
  return missing;
}

StabilityFigure warnings_figure(const Scene& loaded) {
  const std::vector<std::string> missing = warnings_missing(loaded);
  StabilityFigure figure{.name = "degenerate input in a file: warnings missing",
                         .measured = static_cast<double>(missing.size()),
                         .bound = 0.0,
                         .unit = "of 4",
                         .details = {}};
  for (const std::string& what : missing) {
    figure.details += (figure.details.empty() ? "" : "; ") + what;
  }
  return figure;
}

/// The clamped albedo of 2.
StabilityFigure albedo_figure(const Scene& loaded) {
  float largest = 0.0F;
  for (const Material& material : loaded.materials) {
    largest = std::max(largest, max_component(material.base_color));
  }
  return {.name = "degenerate input in a file: largest albedo",
          .measured = largest,
          .bound = 1.0,
          .unit = "",
          .details = "of an albedo of 2 in the file"};
}

}  // namespace

std::vector<StabilityFigure> check_degenerate_input(const StabilityRun& run) {
  constexpr double steps = 5.0;
  std::vector<StabilityFigure> figures;
  int done = 0;
  const auto advance = [&] { run.progress(++done / steps); };
  const auto picture = [&](const Scene& scene, const Vec3& viewpoint, std::uint32_t seed) {
    const PathTracer tracer(scene, run.workers);
    return render_blocks(tracer, viewpoint, {.seed = seed}, run);
  };
  const auto clean = picture(furnished_room(), room_viewpoint, 101);
  advance();
  const Scene spoilt = spoilt_room();
  figures.push_back(picture_difference("degenerate input: picture against the clean one",
                                       picture(spoilt, room_viewpoint, 102), clean, 0.0));
  advance();
  const Scene from_file = through_gltf(spoilt, room_viewpoint, DVec3(0.0));
  figures.push_back(picture_difference("degenerate input in a file: picture against the clean one",
                                       picture(from_file, from_file.cameras.front().position, 103),
                                       clean, 0.0));
  advance();
  Scene extreme = extreme_room();
  figures.push_back(
      not_finite_figure("degenerate input: not finite", extreme, room_viewpoint, run));
  advance();
  extreme.materials[black + 1].base_color = Rgb(2.0F);
  const Scene loaded = through_gltf(extreme, room_viewpoint, DVec3(0.0));
  figures.push_back(not_finite_figure("degenerate input in a file: not finite", loaded,
                                      loaded.cameras.front().position, run));
  figures.push_back(warnings_figure(loaded));
  figures.push_back(albedo_figure(loaded));
  advance();
  return figures;
}

}  // namespace foveola
