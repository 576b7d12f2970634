// Worlds for both renderers: as the reference renderer takes them, and as a Scene.
#pragma once

#include "reference_renderer.h"
#include "renderer/scene/scene.h"
#include "renderer/stability/shapes.h"

namespace foveola::reference {

inline Material material_of(const Surface& surface) {
  Material material = matte(Rgb(surface.color));
  if (surface.kind == Kind::metal) {
    material = metal(1.0F, 0.0F);
    material.base_color = Rgb(surface.color);
  } else if (surface.kind == Kind::glass) {
    material = glass();
    material.ior = static_cast<float>(surface.ior);
  }
  material.emission = Rgb(surface.emission);
  return material;
}

/// Spheres become 82000 triangles, smoothly shaded.
inline Scene scene_of(const World& world) {
  constexpr int sphere_level = 6;
  Scene scene;
  for (const Surface& surface : world.surfaces) {
    scene.materials.push_back(material_of(surface));
  }
  for (const Sphere& sphere : world.spheres) {
    scene.meshes.push_back(placed(
        inside_out(inward_sphere(static_cast<float>(sphere.radius), sphere_level, sphere.surface)),
        1.0F, Quat(1, 0, 0, 0), Vec3(sphere.center)));
  }
  for (const Panel& panel : world.panels) {
    scene.meshes.push_back(quad(Vec3(panel.corner), Vec3(panel.a), Vec3(panel.b), panel.surface));
    if (panel.is_triangle) {
      Mesh& mesh = scene.meshes.back();
      mesh.positions = {Vec3(panel.corner), Vec3(panel.corner + panel.a),
                        Vec3(panel.corner + panel.b)};
      mesh.uv_sets.clear();
      mesh.triangles = {{0, 1, 2}};
    }
  }
  if (max_component(Rgb(world.environment)) > 0.0F) {
    scene.environment.emplace();
    scene.environment->radiance = Rgb(world.environment);
  }
  return scene;
}

/// The six sides of the box between two corners; the fronts face out, or in.
inline void add_box(World& world, const DVec3& lower, const DVec3& upper, int surface,
                    bool fronts_inside) {
  const DVec3 size = upper - lower;
  for (int axis = 0; axis < 3; ++axis) {
    DVec3 a(0.0);
    DVec3 b(0.0);
    DVec3 across(0.0);
    a[(axis + 1) % 3] = size[(axis + 1) % 3];
    b[(axis + 2) % 3] = size[(axis + 2) % 3];
    across[axis] = size[axis];
    // a x b points along +axis: out of the upper side, into the box from the lower one.
    const DVec3& upper_a = fronts_inside ? b : a;
    const DVec3& upper_b = fronts_inside ? a : b;
    world.panels.push_back({lower + across, upper_a, upper_b, surface});
    world.panels.push_back({lower, upper_b, upper_a, surface});
  }
}

enum : int { grey, red, mirror, clear, bright };

inline std::vector<Surface> palette() {
  return {{.color = DVec3(0.7, 0.7, 0.65)},
          {.color = DVec3(0.7, 0.2, 0.1)},
          {.kind = Kind::metal, .color = DVec3(0.9, 0.7, 0.4)},
          {.kind = Kind::glass},
          {.color = DVec3(0.3), .emission = DVec3(4.0, 3.5, 3.0)}};
}

/// Balls of all kinds on a floor under a coloured sky.
inline World balls_under_sky() {
  World world{.surfaces = palette(), .environment = DVec3(0.5, 0.7, 1.0)};
  world.panels = {{DVec3(-4, 0, 4), DVec3(8, 0, 0), DVec3(0, 0, -8), grey}};
  world.spheres = {{DVec3(-1.4, 0.6, -1.5), 0.6, red},
                   {DVec3(0.0, 0.6, -1.6), 0.6, clear},
                   {DVec3(1.4, 0.6, -1.5), 0.6, mirror},
                   {DVec3(0.3, 0.5, 1.5), 0.5, bright}};
  return world;
}

/// A closed room with a broad lamp, a glass block, a mirror and a glass ball.
inline World lit_room() {
  World world{.surfaces = palette()};
  add_box(world, DVec3(-2, -1, -2), DVec3(2, 2, 2), grey, true);
  add_box(world, DVec3(-1.2, -0.9, -1.5), DVec3(-0.4, 0.3, -0.9), clear, false);
  world.panels.push_back({DVec3(-1.5, 1.9, -1.5), DVec3(3, 0, 0), DVec3(0, 0, 3), bright});
  world.panels.push_back({DVec3(1.9, -0.8, -1), DVec3(0, 0, 2), DVec3(0, 2, 0), mirror});
  world.panels.push_back({DVec3(-1.9, -0.9, 0), DVec3(1.5, 0, 0.5), DVec3(0, 1, 0.5), red, true});
  world.spheres = {{DVec3(0.6, -0.4, -1.0), 0.5, clear}, {DVec3(0.5, -0.5, 1.2), 0.4, red}};
  return world;
}

/// Mirrors and glass that face each other under lamps and sky.
inline World hall_of_mirrors() {
  World world{.surfaces = palette(), .environment = DVec3(0.6, 0.5, 0.4)};
  world.panels = {{DVec3(-3, -1, 3), DVec3(6, 0, 0), DVec3(0, 0, -6), red},
                  {DVec3(-2, -1, -2), DVec3(4, 0, 0), DVec3(0, 3, 0), mirror},
                  {DVec3(-2, -1, 2), DVec3(0, 3, 0), DVec3(4, 0, 0), mirror},
                  {DVec3(-1, 2.5, -1), DVec3(2, 0, 0), DVec3(0, 0, 2), bright}};
  add_box(world, DVec3(-1.5, -0.99, -1.0), DVec3(-1.3, 1.0, 1.0), clear, false);
  world.spheres = {{DVec3(1.3, 0.0, 0.2), 0.7, clear}, {DVec3(0.4, -0.5, -1.2), 0.4, mirror}};
  return world;
}

}  // namespace foveola::reference
