#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "renderer/stability/checks.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/estimate.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// Allowance for floats, above all for the offset of rays from the surface.
constexpr double float_slack = 1e-4;

constexpr float floor_albedo = 0.8F;

/// A floor at y = 0, which is the scene's first material and mesh.
Scene floor_scene() {
  Scene scene;
  scene.materials = {matte(Rgb(floor_albedo))};
  scene.meshes = {quad(Vec3(-9, 0, 9), Vec3(18, 0, 0), Vec3(0, 0, -18), 0)};
  return scene;
}

/// The floor at the origin, seen from the side, compared with this irradiance.
StabilityFigure floor_against(std::string name, const Scene& scene, const DVec3& irradiance,
                              const StabilityRun& run) {
  const DVec3 expected = static_cast<double>(floor_albedo) / pi * irradiance;
  const PathTracer tracer(scene, run.workers);
  const Measurement floor =
      single_ray(Vec3(-1.0F, 0.5F, -0.7F), Vec3(1.0F, -0.5F, 0.7F), 1, expected.g);
  return deviation(std::move(name), measure(tracer, floor, run), expected, float_slack,
                   run.effort.tolerance);
}

/// Radiance is Le + Kd Le + Kd^2 Le + ... = 1 everywhere inside.
StabilityFigure emitting_enclosure(std::string name, Mesh enclosure, const StabilityRun& run) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  scene.materials[0].emission = Rgb(0.5F);
  scene.meshes = {std::move(enclosure)};
  const PathTracer tracer(scene, run.workers);
  const Measurement around{.viewpoint = Vec3(0.3F, -0.2F, 0.1F),
                           .direction = uniform_direction,
                           .max_depth = 40,
                           .expected = 1.0};
  return deviation(std::move(name), measure(tracer, around, run), DVec3(1.0), float_slack,
                   run.effort.tolerance);
}

/// Irradiance from a convex mesh of radiance 1 around `center`: that of the triangles facing the
/// point, none of which hides another.
double convex_mesh_irradiance(const Mesh& mesh, const DVec3& center, const DVec3& point,
                              const DVec3& normal) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<DVec3, 3> corners{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    const DVec3 front = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const bool faces_point = glm::dot(point - corners[0], front) > 0.0;
    if (faces_point && glm::dot(front, corners[0] - center) > 0.0) {
      sum += std::abs(polygon_irradiance(corners, point, normal));
    }
  }
  return sum;
}

StabilityFigure sphere_light(const StabilityRun& run) {
  const Vec3 center(0.4F, 2.0F, 0.3F);
  constexpr float radius = 0.5F;
  Scene scene = floor_scene();
  scene.materials.push_back(lamp(Rgb(3.0F)));
  scene.meshes.push_back(
      placed(flat_shaded(inside_out(inward_sphere(radius, 4, 1))), 1.0F, Quat(1, 0, 0, 0), center));
  const double irradiance =
      3.0 * convex_mesh_irradiance(scene.meshes[1], center, DVec3(0.0), DVec3(0, 1, 0));
  const DVec3 to(center);
  const double of_sphere = 3.0 * pi * radius * radius * to.y / std::pow(glm::length(to), 3.0);
  StabilityFigure figure =
      floor_against("sphere light's irradiance", scene, DVec3(irradiance), run);
  figure.details += fmt::format("; tessellation takes {:.2f} % off the true sphere's",
                                100.0 * (1.0 - irradiance / of_sphere));
  return figure;
}

StabilityFigure rectangle_light(const StabilityRun& run) {
  Scene scene = floor_scene();
  scene.materials.push_back(lamp(Rgb(2.0F, 1.0F, 0.5F)));
  scene.meshes.push_back(quad(Vec3(0, 1.5F, 0), Vec3(2, 0, 0), Vec3(0, 0, 1), 1));
  const double irradiance = pi * corner_rectangle_form_factor(2.0, 1.0, 1.5);
  return floor_against("rectangle's form factor", scene, irradiance * DVec3(2.0, 1.0, 0.5), run);
}

/// A lamp at (0.6, 1.2, -0.4) that points straight down, if it has a direction.
PunctualLight lamp_of(PunctualLight::Kind kind) {
  PunctualLight light;
  light.kind = kind;
  light.position = Vec3(0.6F, 1.2F, -0.4F);
  light.direction = Vec3(0, -1, 0);
  light.intensity = Rgb(5.0F, 2.0F, 1.0F);
  return light;
}

/// Irradiance of the floor at the origin from radiant intensity 1 at the lamp's place. A fully
/// visible sphere of any radius gives the same.
double from_lamp() {
  const DVec3 to(Vec3(0.6F, 1.2F, -0.4F));
  return to.y / std::pow(glm::length(to), 3.0);
}

StabilityFigure lit_by(std::string name, const PunctualLight& light, double irradiance,
                       const StabilityRun& run) {
  Scene scene = floor_scene();
  scene.lights = {light};
  return floor_against(std::move(name), scene, irradiance * DVec3(light.intensity), run);
}

StabilityFigure point_light(float radius_m, const StabilityRun& run) {
  PunctualLight light = lamp_of(PunctualLight::Kind::point);
  light.radius_m = radius_m;
  return lit_by(radius_m > 0.0F ? "point light with a radius" : "point light", light, from_lamp(),
                run);
}

/// KHR_lights_punctual, "Inner and Outer Cone Angles": the squared ramp over the cosine.
StabilityFigure spot_light(const StabilityRun& run) {
  PunctualLight light = lamp_of(PunctualLight::Kind::spot);
  light.inner_cone_rad = 0.2F;
  light.outer_cone_rad = 0.9F;
  const double cosine = 1.2 / glm::length(DVec3(light.position));
  const double outer = std::cos(0.9);
  const double ramp = (cosine - outer) / (std::cos(0.2) - outer);
  return lit_by("spot light in its penumbra", light, ramp * ramp * from_lamp(), run);
}

StabilityFigure directional_light(float angular_radius_rad, const StabilityRun& run) {
  PunctualLight light = lamp_of(PunctualLight::Kind::directional);
  light.direction = glm::normalize(Vec3(-0.6F, -0.8F, 0.0F));
  light.angular_radius_rad = angular_radius_rad;
  return lit_by(angular_radius_rad > 0.0F ? "sun of an angular radius" : "directional light", light,
                0.8, run);
}

/// A slab of coloured glass between y = -0.5 and 0, and a sheet of radiance 1 below or above it.
Scene slab_scene(bool from_below, const Rgb& attenuation_color) {
  Scene scene;
  scene.materials = {glass(), lamp(Rgb(1.0F))};
  scene.materials[0].attenuation_color = attenuation_color;
  scene.materials[0].attenuation_distance_m = 0.5F;
  Mesh slab = inside_out(inward_box(Vec3(0.0F), 0.25F, 0));
  for (Vec3& p : slab.positions) {
    p = Vec3(40.0F * p.x, p.y - 0.25F, 40.0F * p.z);
  }
  const float side = from_below ? -1.0F : 1.0F;
  scene.meshes = {slab, quad(Vec3(-9, side, side * -9), Vec3(18, 0, 0), Vec3(0, 0, side * 18), 1)};
  return scene;
}

StabilityFigure glass_slab(bool transmitted, double cosine, const StabilityRun& run) {
  const Rgb color(0.8F, 0.5F, 0.2F);
  DVec3 expected;
  for (int channel = 0; channel < 3; ++channel) {
    const GlassSlab slab{.ior = 1.5,
                         .thickness_m = 0.5,
                         .attenuation_per_m = -std::log(static_cast<double>(color[channel])) / 0.5};
    const SlabShares shares = slab_shares(slab, cosine);
    expected[channel] = transmitted ? shares.transmitted : shares.reflected;
  }
  const Scene scene = slab_scene(transmitted, color);
  const PathTracer tracer(scene, run.workers);
  const auto sine = static_cast<float>(std::sqrt(1.0 - cosine * cosine));
  const auto down = static_cast<float>(cosine);
  const Measurement look =
      single_ray(Vec3(0.1F, 0.5F, 0.2F), Vec3(0.8F * sine, -down, 0.6F * sine), 40, expected.b);
  return deviation(fmt::format("absorbing glass slab, {} at cosine {}",
                               transmitted ? "transmittance" : "reflectance", cosine),
                   measure(tracer, look, run), expected, float_slack, run.effort.tolerance);
}

}  // namespace

std::vector<StabilityFigure> check_known_answers(const StabilityRun& run) {
  const std::vector<std::function<StabilityFigure()>> answers = {
      [&] {
        return emitting_enclosure("unit sphere, Le 0.5, Kd 0.5",
                                  flat_shaded(inward_sphere(1.0F, 4, 0)), run);
      },
      [&] {
        return emitting_enclosure("box, Le 0.5, Kd 0.5", inward_box(Vec3(0.0F), 1.0F, 0), run);
      },
      [&] { return sphere_light(run); },
      [&] { return rectangle_light(run); },
      [&] { return point_light(0.0F, run); },
      [&] { return point_light(0.3F, run); },
      [&] { return spot_light(run); },
      [&] { return directional_light(0.0F, run); },
      [&] { return directional_light(0.1F, run); },
      [&] { return glass_slab(true, 1.0, run); },
      [&] { return glass_slab(true, 0.4, run); },
      [&] { return glass_slab(false, 1.0, run); },
      [&] { return glass_slab(false, 0.4, run); },
  };
  std::vector<StabilityFigure> figures;
  for (const auto& answer : answers) {
    figures.push_back(answer());
    run.progress(static_cast<double>(figures.size()) / static_cast<double>(answers.size()));
  }
  return figures;
}

}  // namespace foveola
