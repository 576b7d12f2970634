// The arcade's walls, floors, arches, vaults and ceilings.
#include "scenes/modelling/architecture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/arcade/parts.h"

namespace foveola::scenes::arcade {
namespace {

using std::numbers::pi;
constexpr double outside = walk_depth + wall_thickness;

/// A step of one stone, 3 m long, that feet have hollowed in its middle.
Shape worn_step() {
  constexpr double depth = 0.34;
  constexpr double height = 0.3;
  const Shape stone = rounded_box({bay - 0.006, height, depth}, 0.018, 1, 4);
  const Shape worn = deformed(stone, [](const DVec3& p) {
    const double middle = std::exp(-2.5 * p.x * p.x);
    const double front = 0.5 + p.z / depth;
    const double top = std::max(0.0, p.y / (0.5 * height));
    return DVec3(p.x, p.y - 0.022 * middle * front * top, p.z);
  });
  return moved(worn, {0.0, -0.01 - 0.5 * height, 0.34});
}

/// A moulding's outline, closed and counter-clockwise: a fillet, a roll and a hollow.
std::vector<DVec2> archivolt_profile() {
  constexpr double back = -0.04;
  return {{back, 0.0},   {0.02, 0.0},    {0.045, 0.02}, {0.045, 0.05},
          {0.02, 0.075}, {0.055, 0.125}, {0.055, 0.15}, {back, 0.15}};
}

/// One bay's arch with a moulding on the court's side and a keystone, from its springing.
Shape moulded_arch(double top) {
  Shape shape = arch(
      {.bay_width = bay, .opening_width = arch_opening, .height = top, .thickness = arch_thickness},
      24);
  const double face = 0.5 * arch_thickness;
  const Shape moulding =
      swept(round_arch_path(0.5 * arch_opening + 0.01, 0.0, 24), archivolt_profile(), {0, 0, 1});
  append(shape, moved(moulding, {0.0, 0.0, face}));
  const double crown = 0.5 * arch_opening;
  const Shape key = deformed(rounded_box({0.22, 0.3, 0.2}, 0.015, 1), [](const DVec3& p) {
    return DVec3(p.x * (1.0 + 0.9 * p.y), p.y, p.z * (1.0 + 0.8 * p.y));
  });
  append(shape, moved(key, {0.0, crown + 0.11, face}));
  return shape;
}

/// A groined vault over [-half_x, half_x] by [-half_z, half_z], its springing at y = 0: where two
/// half-round barrels cross, seen from below. uvs in metres.
Shape groined_vault(double vault_half_x, double vault_half_z, double rise) {
  Shape webs;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const bool across_x = quarter % 2 == 0;
    const double sign = quarter < 2 ? 1.0 : -1.0;
    // In each quarter the height follows the barrel that runs outwards: k is its angle.
    Shape web = patch(12, 4, [&](double u, double r) {
      const double k = r * std::sin(0.5 * pi * (2.0 * u - 1.0));
      const double height = rise * std::sqrt(std::max(0.0, 1.0 - k * k));
      const double s = across_x ? -sign * k : sign * r;
      const double t = across_x ? sign * r : sign * k;
      return DVec3(s * vault_half_x, height, t * vault_half_z);
    });
    for (std::size_t i = 0; i < web.uvs.size(); ++i) {
      const DVec3& p = web.positions[i];
      const double arc =
          std::asin(glm::clamp((across_x ? p.x / vault_half_x : p.z / vault_half_z), -1.0, 1.0));
      web.uvs[i] = {across_x ? p.z : p.x, 1.5 * arc};
    }
    append(webs, web);
  }
  return inside_out(webs);
}

}  // namespace

Shape ring_around_court(double inner, double outer, double bottom, double top) {
  constexpr double overlap = 1e-3;  // edges that only touch would belong to two boxes
  Shape shape;
  for (const double side : {-1.0, 1.0}) {
    const double z0 = side * (half_z + inner);
    const double z1 = side * (half_z + outer);
    append(shape, box({-half_x - outer, bottom, std::min(z0, z1)},
                      {half_x + outer, top, std::max(z0, z1)}));
    const double x0 = side * (half_x + inner);
    const double x1 = side * (half_x + outer);
    append(shape, box({std::min(x0, x1), bottom, -half_z - inner - overlap},
                      {std::max(x0, x1), top, half_z + inner + overlap}));
  }
  return shape;
}

Shape in_each_bay(const Shape& shape) {
  Shape all;
  for_each_bay([&](double x, double z, double turn_deg) {
    append(all, moved(turned(shape, turn_deg), {x, 0.0, z}));
  });
  return all;
}

void add_floors(Model& model, const Materials& m) {
  const Shape court = rectangle({-half_x, court_floor, half_z}, {2.0 * half_x, 0.0, 0.0},
                                {0.0, 0.0, -2.0 * half_z});
  // Around the fountain lies a disc of inlaid stone, a little higher than the slabs.
  constexpr double inlay_radius = 2.3;
  const DVec3 middle(0.8, court_floor, 0.0);
  Shape inlay = lathe({{inlay_radius + 0.01, 0.0}, {inlay_radius, 0.008}, {0.0, 0.008}}, 96);
  inlay = with_projected_uvs(inlay, {0.5 / inlay_radius, 0, 0}, {0, 0, 0.5 / inlay_radius});
  for (DVec2& uv : inlay.uvs) {
    uv += DVec2(0.5);
  }
  add_object(model, "Court floor",
             {{m.paving, with_uv_scale(court, 1.0 / 3.0)}, {m.rosette, moved(inlay, middle)}});
  Shape floors = ring_around_court(-0.2, outside, court_floor - 0.3, 0.0);
  append(floors, ring_around_court(-0.2, outside, upper_floor, upper_walk));
  add_object(model, "Walks", {{m.walk_tiles, with_uv_scale(floors, 1.0 / 2.4)}});
  // Stones of two sides meet in the corners, hence at heights that differ a little.
  Shape steps;
  for_each_bay([&](double x, double z, double turn_deg) {
    const bool along_x = std::abs(z) == half_z;
    append(steps, moved(turned(worn_step(), turn_deg), {x, along_x ? 0.0 : -0.004, z}));
  });
  add_object(model, "Steps", {{m.limestone, with_uv_scale(steps, 0.5), 50.0}});
}

void add_walls(Model& model, const Materials& m) {
  add_object(
      model, "Outer walls",
      {{m.brick, with_uv_scale(ring_around_court(walk_depth, outside, -0.3, roof_top), 0.5)}});
  Shape stone = ring_around_court(-0.3, 0.3, upper_floor - 0.3, upper_floor - 0.1);
  append(stone, ring_around_court(-0.36, 0.3, upper_floor - 0.1, upper_floor - 0.05));
  append(stone, ring_around_court(-0.42, 0.3, upper_floor - 0.05, upper_floor));
  append(stone, ring_around_court(-0.36, 0.35, upper_ceiling, upper_ceiling + 0.1));
  append(stone, ring_around_court(-0.44, 0.35, upper_ceiling + 0.1, upper_ceiling + 0.2));
  // Small blocks under both cornices.
  constexpr int blocks_in_bay = 12;
  Shape blocks;
  for (int i = 0; i < blocks_in_bay; ++i) {
    const double x = (i + 0.5 - 0.5 * blocks_in_bay) * bay / blocks_in_bay;
    append(blocks, moved(box(DVec3(0.1, 0.07, 0.1)), {x, upper_floor - 0.13, 0.345}));
    append(blocks, moved(box(DVec3(0.1, 0.09, 0.1)), {x, upper_ceiling - 0.04, 0.3}));
  }
  append(stone, in_each_bay(blocks));
  add_object(model, "Cornices", {{m.limestone, with_uv_scale(stone, 0.5)}});
  Shape dado = ring_around_court(walk_depth - 0.04, walk_depth, 0.0, 0.16);
  append(dado, ring_around_court(walk_depth - 0.03, walk_depth, upper_walk, upper_walk + 0.14));
  add_object(model, "Skirting", {{m.limestone, with_uv_scale(dado, 0.5)}});
}

void add_arches(Model& model, const Materials& m) {
  Shape arches = moved(in_each_bay(moulded_arch(upper_floor - 0.3 - lower_springing)),
                       {0.0, lower_springing, 0.0});
  append(arches, moved(in_each_bay(moulded_arch(upper_ceiling - upper_springing)),
                       {0.0, upper_springing, 0.0}));
  add_object(model, "Arches", {{m.ashlar, with_uv_scale(arches, 0.5)}});
}

void add_vaults(Model& model, const Materials& m) {
  constexpr double rise = 1.46;
  constexpr double inner = 0.5 * arch_thickness;
  constexpr double vault_depth = walk_depth - inner;
  const Shape vault = moved(groined_vault(0.5 * bay, 0.5 * vault_depth, rise),
                            {0.0, lower_springing, -inner - 0.5 * vault_depth});
  Shape vaults = in_each_bay(vault);
  constexpr double corner_half = 0.5 * (walk_depth - 0.15);
  const Shape corner_vault = groined_vault(corner_half, corner_half, rise);
  for_each_corner([&](double x, double z) {
    constexpr double out = walk_depth - corner_half;
    append(vaults, moved(corner_vault,
                         {x + std::copysign(out, x), lower_springing, z + std::copysign(out, z)}));
  });
  append(vaults, ring_around_court(0.3, outside, lower_ceiling, upper_floor));
  add_object(model, "Vaults", {{m.plaster, with_uv_scale(vaults, 0.5)}});
  // A rib with its pilaster spans the walk behind each column, and at both sides of each corner.
  Shape rib = moved(turned(arch({.bay_width = walk_depth,
                                 .opening_width = walk_depth - 0.5,
                                 .height = lower_ceiling - lower_springing,
                                 .thickness = 0.36},
                                22),
                           90.0),
                    {0.0, lower_springing, -0.5 * walk_depth});
  const DVec3 foot(0.0, 0.0, -walk_depth + 0.12);
  append(rib, moved(rounded_box({0.44, lower_springing - 0.1, 0.24}, 0.012, 1),
                    foot + DVec3(0.0, 0.5 * lower_springing, 0.0)));
  append(rib, moved(rounded_box({0.52, 0.12, 0.3}, 0.02, 1),
                    foot + DVec3(0.0, lower_springing - 0.06, 0.0)));
  append(rib, moved(rounded_box({0.52, 0.24, 0.3}, 0.02, 1), foot + DVec3(0.0, 0.12, 0.0)));
  Shape ribs;
  for_each_column([&](double x, double z, double turn_deg) {
    append(ribs, moved(turned(rib, turn_deg), {x, 0.0, z}));
  });
  for_each_corner([&](double x, double z) {
    append(ribs, moved(turned(rib, z < 0.0 ? 0.0 : 180.0), {x, 0.0, z}));
    append(ribs, moved(turned(rib, x < 0.0 ? 90.0 : -90.0), {x, 0.0, z}));
  });
  add_object(model, "Ribs", {{m.limestone, with_uv_scale(ribs, 0.5)}});
}

void add_upper_ceiling(Model& model, const Materials& m) {
  const Shape boards = ring_around_court(0.35, outside, upper_ceiling + 0.1, roof_top);
  // Beams across and along the walk make coffers; where they cross the former reach lower.
  constexpr int beams_in_bay = 4;
  Shape beams;
  for (int i = 0; i < beams_in_bay; ++i) {
    const double along = (i + 0.5 - 0.5 * beams_in_bay) * bay / beams_in_bay;
    append(beams, moved(box(DVec3(0.13, 0.24, walk_depth - 0.2)),
                        {along, upper_ceiling, -0.5 * walk_depth - 0.1}));
  }
  Shape coffers = in_each_bay(beams);
  for (const double along : {0.35, 1.05, 1.75, 2.45, 3.12}) {
    append(coffers, ring_around_court(along - 0.05, along + 0.05, upper_ceiling - 0.04,
                                      upper_ceiling + 0.11));
  }
  add_object(model, "Roof", {{m.wood, boards}, {m.old_wood, coffers}});
}

void add_roof_edge(Model& model, const Materials& m) {
  // Half-round tiles, bellies up over bellies down, whose ends hang over the cornice.
  constexpr int tiles_in_bay = 13;
  constexpr double spacing = bay / tiles_in_bay;
  constexpr double length = 0.9;
  constexpr double thickness = 0.016;
  const auto half_pipe = [&](double radius, double sign) {
    const auto ring = [&](double r, double u) {
      const double angle = pi * u;
      return DVec2(r * std::cos(angle), sign * r * std::sin(angle));
    };
    // Around the tile's section: out along its upper side, back along its lower.
    const Shape side = patch(9, 1, [&](double u, double v) {
      const int i = static_cast<int>(std::lround(9.0 * u));
      const DVec2 p = i < 5   ? ring(radius, i / 4.0)
                      : i < 9 ? ring(radius - thickness, (8 - i) / 3.0)
                              : ring(radius, 0.0);
      return DVec3(p, -length * v);
    });
    const Shape end = patch(4, 1, [&](double u, double v) {
      return DVec3(ring(radius - thickness * (1.0 - v), u), 0.0);
    });
    Shape tile = sign > 0.0 ? inside_out(side) : side;
    append(tile, sign > 0.0 ? inside_out(end) : end);
    return tile;
  };
  Shape eave;
  for (int i = 0; i < tiles_in_bay; ++i) {
    const double x = (i + 0.5 - 0.5 * tiles_in_bay) * spacing;
    const double slip = 0.02 * std::sin(7.3 * i);
    append(eave, moved(half_pipe(0.09, -1.0), {x - 0.5 * spacing, 0.03, slip}));
    append(eave, moved(half_pipe(0.075, 1.0), {x, 0.0, 0.03 - slip}));
  }
  constexpr double pitch_deg = 18.0;
  const Shape placed = moved(turned(eave, pitch_deg, {1, 0, 0}), {0.0, upper_ceiling + 0.31, 0.6});
  add_object(model, "Roof tiles", {{m.roof_tile, in_each_bay(placed), 50.0}});
}

}  // namespace foveola::scenes::arcade
