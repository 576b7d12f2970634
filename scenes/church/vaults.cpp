// The church's columns, vaults, ribs and mouldings.
#include <cmath>
#include <numbers>

#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"
#include "scenes/modelling/column.h"

namespace foveola::scenes::church {
namespace {

constexpr double aisle_springing = 4.6;
constexpr double aisle_rise = 2.3;
constexpr double webs_per_metre = 0.45;
/// Vaults reach this far into the walls, and past each other under the ribs.
constexpr double overlap = 0.04;

std::vector<VaultBay> nave_bays() {
  std::vector<VaultBay> vaults;
  for (int i = 0; i < bays; ++i) {
    vaults.push_back({.middle = {bay * (i - 0.5 * (bays - 1)), nave_springing, 0.0},
                      .half_x = 0.5 * bay + overlap,
                      .half_z = arcade_z - 0.5 * wall + overlap,
                      .rise = nave_rise});
  }
  return vaults;
}

std::vector<VaultBay> aisle_bays() {
  const double inner = arcade_z + 0.5 * wall - overlap;
  const double outer = aisle_z + overlap;
  std::vector<VaultBay> vaults;
  for (int i = 0; i < bays; ++i) {
    for (const double side : {-1.0, 1.0}) {
      vaults.push_back(
          {.middle = {bay * (i - 0.5 * (bays - 1)), aisle_springing, side * 0.5 * (inner + outer)},
           .half_x = 0.5 * bay + overlap,
           .half_z = 0.5 * (outer - inner),
           .rise = aisle_rise});
    }
  }
  return vaults;
}

/// Ribs under the groins of a vault and along its edge at -X.
Shape ribs(const VaultBay& vault, double width, int segments) {
  Shape shape;
  const auto profile = rib_profile(width, 1.3 * width);
  for (const double turn : {-1.0, 1.0}) {
    const DVec3 side = glm::normalize(DVec3(-turn * vault.half_z, 0.0, vault.half_x));
    append(shape, swept(vault_line(vault, {-1.0, -turn}, {1.0, turn}, segments), profile, side));
  }
  return shape;
}

Shape transverse_rib(const VaultBay& vault, double end, double width, int segments) {
  return swept(vault_line(vault, {end, -1.0}, {end, 1.0}, segments),
               rib_profile(width, 0.9 * width), {-1.0, 0.0, 0.0});
}

/// The carved stone where ribs meet; hangs from the origin.
Shape boss(double radius) {
  Shape shape = lathe({{0.0, -0.55 * radius},
                       {0.35 * radius, -0.5 * radius},
                       {0.45 * radius, -0.35 * radius},
                       {0.8 * radius, -0.35 * radius},
                       {radius, -0.2 * radius},
                       {radius, 0.3 * radius},
                       {0.0, 0.3 * radius}},
                      14);
  for (int i = 0; i < 6; ++i) {
    append(shape, turned(moved(ellipsoid({0.17 * radius, 0.12 * radius, 0.25 * radius}, 6),
                               {0.0, -0.36 * radius, 0.68 * radius}),
                         60.0 * i));
  }
  return shape;
}

/// The vault over one side of the apse, or over the straight part of the choir: from the wall's
/// upper edge, from `a` to `b`, to the ridge from `top_a` to `top_b`.
Shape choir_web(const DVec3& a, const DVec3& b, const DVec3& top_a, const DVec3& top_b) {
  Shape web = patch(8, 12, [&](double u, double v) {
    const double outwards = 1.01 - 1.01 * std::sin(0.5 * std::numbers::pi * v);
    const DVec3 foot = glm::mix(a, b, u);
    const DVec3 top = glm::mix(top_a, top_b, u);
    DVec3 p = glm::mix(top, foot, outwards);
    p.y = choir_springing + choir_rise * pointed_arch(outwards);
    return p;
  });
  for (DVec2& uv : web.uvs) {
    uv *= DVec2(glm::distance(a, b), 4.6);
  }
  return inside_out(web);
}

/// The rib from a corner of the apse to the ridge over its middle.
Shape choir_rib(const DVec3& corner, const DVec3& top) {
  std::vector<DVec3> path;
  constexpr int segments = 12;
  for (int i = 0; i <= segments; ++i) {
    const double outwards = 1.0 - std::sin(0.5 * std::numbers::pi * i / segments);
    DVec3 p = glm::mix(top, corner, outwards);
    p.y = choir_springing + choir_rise * pointed_arch(outwards);
    path.push_back(p);
  }
  const DVec3 inwards = glm::normalize(DVec3(top.x - corner.x, 0.0, top.z - corner.z));
  return swept(path, rib_profile(0.16, 0.24), glm::cross(inwards, DVec3(0.0, 1.0, 0.0)));
}

void add_choir_vault(Model& model, const Materials& m) {
  const DVec3 top(apse_x, 0.0, 0.0);
  const DVec3 back(half_length + wall - overlap - apse_x, 0.0, 0.0);
  Shape webs;
  Shape choir_ribs;
  Shape shafts;
  for (int i = 0; i < 5; ++i) {
    append(webs, choir_web(apse_corner(i), apse_corner(i + 1), top, top));
  }
  append(webs, choir_web(apse_corner(0) + back, apse_corner(0), top + back, top));
  append(webs, choir_web(apse_corner(5), apse_corner(5) + back, top, top + back));
  for (int i = 0; i < 6; ++i) {
    append(choir_ribs, choir_rib(apse_corner(i), top));
    append(shafts, moved(shaft(0.1, choir_springing - choir_floor, 8), apse_corner(i)));
  }
  const DVec3 ridge(apse_x, choir_springing + choir_rise, 0.0);
  append(choir_ribs, moved(boss(0.35), ridge));
  add_object(model, "Choir vault", {{m.sky_vault, with_uv_scale(webs, 0.4), 60.0}});
  add_object(model, "Choir ribs", {{m.limestone, choir_ribs, 30.0}, {m.limestone, shafts, 30.0}});
}

/// Shafts on the nave's walls from the columns' slabs to the vault, and on the aisles' outer walls.
Shape wall_shafts() {
  Shape shafts;
  for (int i = 0; i <= bays; ++i) {
    const double x = bay * (i - 0.5 * bays);
    for (const double side : {-1.0, 1.0}) {
      append(shafts, moved(shaft(0.13, nave_springing - column_height + 0.1, 8),
                           {x, column_height, side * (arcade_z - 0.5 * wall - 0.02)}));
      append(shafts, moved(shaft(0.16, aisle_springing + 0.1, 10), {x, 0.0, side * aisle_z}));
    }
  }
  return shafts;
}

/// The rounded edge of each arch of the arcade, on both faces.
Shape arcade_mouldings() {
  const double radius = 0.5 * arcade_opening;
  const std::vector<DVec2> roll = {
      {0.06, 0.02}, {0.02, 0.06}, {-0.04, 0.04}, {-0.04, -0.04}, {0.02, -0.06}};
  Shape shape;
  for (int i = 0; i < bays; ++i) {
    for (const double side : {-1.0, 1.0}) {
      for (const double face : {-1.0, 1.0}) {
        const DVec3 middle(bay * (i - 0.5 * (bays - 1)), column_height,
                           side * arcade_z + face * 0.5 * wall);
        append(shape,
               moved(swept(round_arch_path(radius + 0.02, 0.0, 14), roll, {0, 0, 1}), middle));
      }
    }
  }
  return shape;
}

/// Mouldings that run along the nave: under the upper windows and over the arches.
Shape string_courses() {
  Shape shape;
  for (const double side : {-1.0, 1.0}) {
    const double z = side * (arcade_z - 0.5 * wall);
    for (const double y : {gallery + 0.02, 6.35}) {
      append(shape, swept({{-half_length - 0.05, y, z}, {half_length + 0.05, y, z}},
                          rib_profile(0.2, 0.16), {0, 0, 1}));
    }
  }
  const double x = half_length;
  append(shape, swept({{x, gallery + 0.7, arcade_z}, {x, gallery + 0.7, -arcade_z}},
                      rib_profile(0.2, 0.16), {1, 0, 0}));
  append(shape,
         swept({{-x, 5.6, -arcade_z}, {-x, 5.6, arcade_z}}, rib_profile(0.2, 0.16), {-1, 0, 0}));
  return shape;
}

/// The arch between nave and choir, whose edge carries three rolls.
Shape choir_arch_moulding() {
  Shape shape;
  for (const double ring : {2.65, 2.95, 3.05}) {
    const auto path = round_arch_path(ring, ring < 2.7 ? 4.3 : 0.0, 32);
    append(shape, moved(turned(swept(path, rib_profile(0.14, 0.14), {0, 0, 1}), 90.0),
                        {half_length, 4.7, 0.0}));
  }
  for (const double side : {-1.0, 1.0}) {
    append(shape, moved(box(DVec3(wall + 0.24, 0.18, 0.6)),
                        {half_length + 0.5 * wall, 4.62, side * 2.87}));
  }
  return shape;
}

}  // namespace

void add_columns(Model& model, const Materials& m) {
  const Shape column = carved_column({.radius = 0.36, .height = column_height, .slab = 1.0});
  int number = 1;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i <= bays; ++i) {
      add_object(
          model, "Column " + std::to_string(number++),
          {{m.limestone, moved(column, {bay * (i - 0.5 * bays), 0.0, side * arcade_z}), 50.0}});
    }
  }
  add_object(model, "Wall shafts", {{m.limestone, wall_shafts()}});
  Shape mouldings = arcade_mouldings();
  append(mouldings, string_courses());
  append(mouldings, choir_arch_moulding());
  add_object(model, "Mouldings", {{m.limestone, mouldings}});
}

void add_vaults(Model& model, const Materials& m) {
  Shape webs;
  Shape rib_shapes;
  Shape bosses;
  for (const VaultBay& vault : nave_bays()) {
    append(webs, vault_webs(vault, 10, 6));
    append(rib_shapes, ribs(vault, 0.2, 18));
    append(rib_shapes, transverse_rib(vault, -1.0, 0.42, 18));
    append(bosses, moved(boss(0.34), on_vault(vault, 0.0, 0.0)));
  }
  append(rib_shapes, transverse_rib(nave_bays().back(), 1.0, 0.42, 18));
  for (const VaultBay& vault : aisle_bays()) {
    append(webs, vault_webs(vault, 8, 4));
    append(rib_shapes, ribs(vault, 0.14, 10));
    append(rib_shapes, transverse_rib(vault, -1.0, 0.3, 10));
    append(bosses, moved(boss(0.2), on_vault(vault, 0.0, 0.0)));
  }
  add_object(model, "Vault", {{m.vault, with_uv_scale(webs, webs_per_metre), 30.0}});
  add_object(model, "Ribs", {{m.limestone, with_uv_scale(rib_shapes, 0.5), 30.0}});
  add_object(model, "Bosses", {{m.gold, bosses}});
  add_choir_vault(model, m);
}

}  // namespace foveola::scenes::church
