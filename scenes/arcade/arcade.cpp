#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/builtin.h"
#include "scenes/modelling/patterns.h"
#include "scenes/modelling/props.h"

namespace foveola::scenes {
namespace {

constexpr double bay = 3.0;
constexpr int bays_x = 6;
constexpr int bays_z = 3;
constexpr double half_x = 0.5 * bays_x * bay;  ///< the court's edge, in the columns' middle
constexpr double half_z = 0.5 * bays_z * bay;
constexpr double walk_depth = 3.2;
constexpr double wall_thickness = 0.4;
constexpr double court_floor = -0.15;
constexpr double lower_springing = 2.9;
constexpr double lower_ceiling = 4.6;
constexpr double upper_floor = 4.9;
constexpr double upper_springing = 7.2;
constexpr double upper_ceiling = 8.8;
constexpr double roof_top = 9.2;

struct Materials {
  int limestone = 0;
  int court_tiles = 0;
  int walk_tiles = 0;
  int brick = 0;
  int plaster = 0;
  int wood = 0;
  int bronze = 0;
  int water = 0;
  int red_cloth = 0;
  int blue_cloth = 0;
  int sun = 0;
  PlantMaterials plant;
};

int add_cloth(Model& model, const char* name, const Rgb& ground, const Rgb& stripe) {
  const int image = add_image(model, cloth(512, 3, ground, stripe, 41));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = 0.95F,
                              .base_color_image = image,
                              .double_sided = true});
}

Materials add_materials(Model& model) {
  Materials m;
  m.limestone =
      add_textured_material(model, "limestone", plaster(512, {0.6F, 0.54F, 0.44F}, 0.25, 11), 0.8F);
  m.court_tiles = add_textured_material(
      model, "court tiles", floor_tiles(512, 8, {0.42F, 0.36F, 0.28F}, {0.36F, 0.3F, 0.24F}, 12),
      0.6F);
  m.walk_tiles = add_textured_material(
      model, "walk tiles", floor_tiles(512, 8, {0.5F, 0.46F, 0.4F}, {0.22F, 0.1F, 0.07F}, 13),
      0.45F);
  m.brick = add_textured_material(model, "brick",
                                  masonry(512,
                                          {.courses = 16,
                                           .stones = 6,
                                           .joint = 0.1,
                                           .variation = 0.3,
                                           .stone = {0.62F, 0.47F, 0.35F},
                                           .mortar = {0.58F, 0.54F, 0.47F}},
                                          14),
                                  0.9F);
  m.plaster =
      add_textured_material(model, "plaster", plaster(512, {0.66F, 0.6F, 0.5F}, 0.15, 15), 0.95F);
  m.wood = add_textured_material(
      model, "wood", wood(512, 4, {0.3F, 0.17F, 0.08F}, {0.13F, 0.065F, 0.03F}, 16), 0.6F);
  m.bronze = add_material(
      model,
      {.name = "bronze", .base_color = {0.55F, 0.36F, 0.17F}, .metallic = 1.0F, .roughness = 0.4F});
  m.water = add_material(
      model, {.name = "water", .base_color = {0.05F, 0.12F, 0.12F}, .roughness = 0.15F});
  m.red_cloth = add_cloth(model, "red cloth", {0.5F, 0.05F, 0.04F}, {0.6F, 0.42F, 0.12F});
  m.blue_cloth = add_cloth(model, "blue cloth", {0.05F, 0.13F, 0.4F}, {0.62F, 0.6F, 0.55F});
  m.sun = add_material(model, {.name = "sun", .emission = {380.0F, 335.0F, 270.0F}});
  m.plant = add_plant_materials(model);
  return m;
}

/// Calls visit(x, z, turn_deg) for the middle of each bay around the court; turned by turn_deg, +Z
/// points from the walk into the court.
template <typename Visit>
void for_each_bay(const Visit& visit) {
  for (int i = 0; i < bays_x; ++i) {
    const double x = -half_x + (i + 0.5) * bay;
    visit(x, -half_z, 0.0);
    visit(x, half_z, 180.0);
  }
  for (int i = 0; i < bays_z; ++i) {
    const double z = -half_z + (i + 0.5) * bay;
    visit(-half_x, z, 90.0);
    visit(half_x, z, -90.0);
  }
}

/// Calls visit(x, z, turn_deg) for each column that is not in a corner, as for_each_bay.
template <typename Visit>
void for_each_column(const Visit& visit) {
  for (int i = 1; i < bays_x; ++i) {
    visit(-half_x + i * bay, -half_z, 0.0);
    visit(-half_x + i * bay, half_z, 180.0);
  }
  for (int i = 1; i < bays_z; ++i) {
    visit(-half_x, -half_z + i * bay, 90.0);
    visit(half_x, -half_z + i * bay, -90.0);
  }
}

template <typename Visit>
void for_each_corner(const Visit& visit) {
  for (const double x : {-half_x, half_x}) {
    for (const double z : {-half_z, half_z}) {
      visit(x, z);
    }
  }
}

/// A ring of four boxes around the court, from `inner` metres outside the columns' middle to
/// `outer`.
Shape ring_around_court(double inner, double outer, double bottom, double top) {
  Shape shape;
  for (const double side : {-1.0, 1.0}) {
    const double z0 = side * (half_z + inner);
    const double z1 = side * (half_z + outer);
    append(shape, box({-half_x - outer, bottom, std::min(z0, z1)},
                      {half_x + outer, top, std::max(z0, z1)}));
    const double x0 = side * (half_x + inner);
    const double x1 = side * (half_x + outer);
    append(shape, box({std::min(x0, x1), bottom, -half_z - inner},
                      {std::max(x0, x1), top, half_z + inner}));
  }
  return shape;
}

void add_shell(Model& model, const Materials& m) {
  add_object(
      model, "Court floor",
      {{m.court_tiles, with_uv_scale(rectangle({-half_x, court_floor, half_z},
                                               {2.0 * half_x, 0.0, 0.0}, {0.0, 0.0, -2.0 * half_z}),
                                     1.0 / 4.0)}});
  const double outside = walk_depth + wall_thickness;
  Shape stone = ring_around_court(-0.5, -0.35, court_floor - 0.3, -0.01);
  append(stone, ring_around_court(-0.32, 0.32, upper_floor - 0.3, upper_floor));
  append(stone, ring_around_court(-0.5, 0.35, upper_ceiling, upper_ceiling + 0.15));
  append(stone, ring_around_court(-0.7, 0.35, upper_ceiling + 0.15, roof_top));
  add_object(model, "Steps and cornices", {{m.limestone, with_uv_scale(stone, 0.5)}});
  Shape floors = ring_around_court(-0.35, outside, court_floor - 0.3, 0.0);
  append(floors, ring_around_court(-0.2, outside, upper_floor, upper_floor + 0.02));
  add_object(model, "Walks", {{m.walk_tiles, with_uv_scale(floors, 1.0 / 4.0)}});
  add_object(model, "Outer walls",
             {{m.brick,
               with_uv_scale(ring_around_court(walk_depth, outside, -0.3, roof_top), 1.0 / 2.0)}});
  add_object(model, "Vault slab",
             {{m.plaster,
               with_uv_scale(ring_around_court(0.32, outside, lower_ceiling, upper_floor), 0.5)}});
  add_object(model, "Roof",
             {{m.wood, ring_around_court(0.35, outside, upper_ceiling + 0.1, roof_top)}});
}

void add_arches(Model& model, const Materials& m) {
  Shape arches;
  for_each_bay([&](double x, double z, double turn_deg) {
    for (const double springing : {lower_springing, upper_springing}) {
      const double top = springing == lower_springing ? upper_floor - 0.3 : upper_ceiling;
      const Shape one = arch(
          {.bay_width = bay, .opening_width = 2.4, .height = top - springing, .thickness = 0.5},
          28);
      append(arches, moved(turned(one, turn_deg), {x, springing, z}));
    }
  });
  add_object(model, "Arches", {{m.plaster, with_uv_scale(arches, 0.5)}});
  Shape ribs;
  Shape beams;
  for_each_column([&](double x, double z, double turn_deg) {
    const Shape rib = arch({.bay_width = walk_depth,
                            .opening_width = walk_depth - 0.5,
                            .height = lower_ceiling - lower_springing,
                            .thickness = 0.36},
                           24);
    const Shape across = moved(turned(rib, 90.0), {0.0, lower_springing, -0.5 * walk_depth});
    append(ribs, moved(turned(across, turn_deg), {x, 0.0, z}));
    const Shape pilaster =
        box({-0.22, 0.0, -walk_depth}, {0.22, lower_springing, -walk_depth + 0.24});
    append(ribs, moved(turned(pilaster, turn_deg), {x, 0.0, z}));
  });
  for_each_bay([&](double x, double z, double turn_deg) {
    for (int i = 0; i < 4; ++i) {
      const double along = (i - 1.5) * bay / 4.0;
      const Shape beam = box({along - 0.06, upper_ceiling - 0.12, -walk_depth},
                             {along + 0.06, upper_ceiling + 0.1, -0.35});
      append(beams, moved(turned(beam, turn_deg), {x, 0.0, z}));
    }
  });
  add_object(model, "Ribs", {{m.limestone, with_uv_scale(ribs, 0.5)}});
  add_object(model, "Beams", {{m.wood, beams}});
}

void add_columns(Model& model, const Materials& m) {
  const Shape lower = column({.radius = 0.2, .height = lower_springing, .slab = 0.62}, 20);
  const Shape upper =
      column({.radius = 0.16, .height = upper_springing - upper_floor, .slab = 0.6}, 16);
  Shape columns;
  for_each_column([&](double x, double z, double) {
    append(columns, moved(lower, {x, 0.0, z}));
    append(columns, moved(upper, {x, upper_floor, z}));
  });
  for_each_corner([&](double x, double z) {
    append(columns, box({x - 0.31, -0.01, z - 0.31}, {x + 0.31, upper_ceiling, z + 0.31}));
  });
  add_object(model, "Columns", {{m.limestone, with_uv_scale(columns, 0.5)}});
}

void add_balustrade(Model& model, const Materials& m) {
  constexpr double height = 0.8;
  const Shape post = baluster(height, 8);
  Shape balustrade;
  for_each_bay([&](double x, double z, double turn_deg) {
    Shape one;
    for (int i = 0; i < 8; ++i) {
      append(one, moved(post, {(i - 3.5) * 0.3, 0.0, 0.0}));
    }
    append(one, box({-1.35, height, -0.1}, {1.35, height + 0.1, 0.1}));
    append(balustrade, moved(turned(one, turn_deg), {x, upper_floor + 0.02, z}));
  });
  add_object(model, "Balustrade", {{m.limestone, with_uv_scale(balustrade, 0.5)}});
}

void add_doors(Model& model, const Materials& m) {
  Shape doors;
  Shape frames;
  for_each_bay([&](double x, double z, double turn_deg) {
    const auto place = [&](const Shape& shape, double floor) {
      return moved(turned(moved(shape, {0.0, floor, -walk_depth}), turn_deg), {x, 0.0, z});
    };
    for (const double floor : {0.0, upper_floor + 0.02}) {
      append(doors, place(box({-0.55, 0.0, 0.0}, {0.55, 2.2, 0.05}), floor));
      append(frames, place(box({-0.7, 0.0, 0.0}, {-0.55, 2.35, 0.1}), floor));
      append(frames, place(box({0.55, 0.0, 0.0}, {0.7, 2.35, 0.1}), floor));
      append(frames, place(box({-0.55, 2.2, 0.0}, {0.55, 2.35, 0.1}), floor));
    }
  });
  add_object(model, "Doors", {{m.wood, doors}, {m.limestone, with_uv_scale(frames, 0.5)}});
}

void add_fountain(Model& model, const Materials& m) {
  const Shape basin = lathe({{0.0, 0.0},
                             {1.15, 0.0},
                             {1.15, 0.1},
                             {1.05, 0.14},
                             {1.0, 0.42},
                             {1.08, 0.48},
                             {1.08, 0.55},
                             {0.92, 0.55},
                             {0.9, 0.3}},
                            64);
  const Shape bowl = lathe({{0.16, 0.3},
                            {0.12, 0.45},
                            {0.1, 0.7},
                            {0.13, 0.85},
                            {0.2, 0.95},
                            {0.42, 1.08},
                            {0.55, 1.22},
                            {0.56, 1.27},
                            {0.5, 1.27},
                            {0.48, 1.22}},
                           48);
  const Shape spout = moved(ellipsoid({0.11, 0.2, 0.11}, 24), {0.0, 1.4, 0.0});
  Shape water = lathe({{0.91, 0.46}, {0.0, 0.46}}, 48);
  append(water, lathe({{0.5, 1.24}, {0.0, 1.24}}, 32));
  const DVec3 place(0.8, court_floor, 0.0);
  add_object(model, "Fountain",
             moved({{m.limestone, basin, 50.0},
                    {m.limestone, bowl, 50.0},
                    {m.bronze, spout, 60.0},
                    {m.water, water, 30.0}},
                   place));
}

void add_urn(Model& model, const Materials& m) {
  std::vector<DVec2> outline = {{0.0, 0.0}, {0.2, 0.0}, {0.22, 0.05}};
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    outline.emplace_back(0.17 + 0.23 * std::sin(std::numbers::pi * std::pow(t, 0.8)),
                         0.08 + 0.72 * t);
  }
  outline.insert(outline.end(),
                 {{0.16, 0.86}, {0.24, 0.92}, {0.24, 0.95}, {0.18, 0.95}, {0.12, 0.85}});
  Shape urn = lathe(outline, 40);
  for (const double side : {-1.0, 1.0}) {
    std::vector<DVec3> handle;
    for (int i = 0; i <= 10; ++i) {
      const double angle = std::numbers::pi * (i / 10.0 - 0.5);
      handle.emplace_back(side * (0.2 + 0.2 * std::cos(angle)), 0.74 + 0.16 * std::sin(angle), 0.0);
    }
    append(urn, tube(handle, 0.025, 10));
  }
  const DVec3 place(-1.0, court_floor, -2.8);
  const Shape plinth = box({-0.3, 0.0, -0.3}, {0.3, 0.5, 0.3});
  add_object(model, "Plinth", moved({{m.limestone, plinth}}, place));
  add_object(model, "Urn", moved({{m.plant.pot, urn, 50.0}}, place + DVec3(0.0, 0.5, 0.0)));
}

void add_plants(Model& model, const Materials& m) {
  const PlantSize large{.pot_radius = 0.36,
                        .pot_height = 0.55,
                        .stem_height = 0.8,
                        .leaf_length = 0.42,
                        .stems = 12,
                        .leaves_per_stem = 6};
  add_object(model, "Large plant",
             moved(potted_plant(large, m.plant, 100), {1.2, court_floor, 3.4}));
  const PlantSize small{.pot_radius = 0.24, .pot_height = 0.36};
  std::uint32_t number = 1;
  for (const DVec3& place :
       {DVec3(-7.8, court_floor, 3.3), DVec3(-7.8, court_floor, -3.3), DVec3(7.8, court_floor, 3.3),
        DVec3(7.8, court_floor, -3.3), DVec3(-3.0, court_floor, 3.6), DVec3(4.4, court_floor, 3.6),
        DVec3(-4.0, court_floor, -3.6), DVec3(4.2, court_floor, -3.7)}) {
    add_object(model, "Plant " + std::to_string(number),
               moved(potted_plant(small, m.plant, 100 + number), place));
    ++number;
  }
}

void add_cloths(Model& model, const Materials& m) {
  const ClothSize curtain{.width = 2.3, .drop = 2.7, .folds = 7, .fold_depth = 0.09};
  const ClothSize banner{.width = 1.7, .drop = 2.6, .folds = 3, .fold_depth = 0.07};
  struct Hanging {
    const char* name;
    int material;
    ClothSize size;
    DVec3 place;
    double turn_deg;
  };
  const std::vector<Hanging> hangings = {
      {"Red banner", m.red_cloth, banner, {4.5, upper_floor + 0.1, -half_z + 0.5}, 0.0},
      {"Blue banner", m.blue_cloth, banner, {-4.5, upper_floor + 0.1, -half_z + 0.5}, 0.0},
      {"Far banner", m.blue_cloth, banner, {half_x - 0.5, upper_floor + 0.1, 0.0}, -90.0},
      {"Near banner", m.red_cloth, banner, {-half_x + 0.5, upper_floor + 0.1, 0.0}, 90.0},
      {"Blue curtain", m.blue_cloth, curtain, {4.5, lower_springing, half_z}, 180.0},
      {"Red curtain", m.red_cloth, curtain, {-1.5, lower_springing, half_z}, 180.0},
      {"Side curtain", m.red_cloth, curtain, {-1.5, lower_springing, -half_z}, 0.0},
      {"Corner curtain", m.blue_cloth, curtain, {7.5, lower_springing, -half_z}, 0.0},
  };
  std::uint32_t seed = 200;
  for (const Hanging& hanging : hangings) {
    const double rod_end = 0.5 * hanging.size.width + 0.08;
    const Shape rod = tube({{-rod_end, 0.0, 0.0}, {rod_end, 0.0, 0.0}}, 0.025, 10);
    const auto place = [&](const Shape& shape) {
      return moved(turned(shape, hanging.turn_deg), hanging.place);
    };
    add_object(model, hanging.name,
               {{hanging.material, place(hanging_cloth(hanging.size, seed++)), 80.0},
                {m.bronze, place(rod)}});
  }
}

/// The sun as a glowing disc, far larger than the real one so that a path tracer finds it easily.
void add_sun(Model& model, const Materials& m) {
  constexpr double distance = 60.0;
  constexpr double radius = 4.0;
  const DVec3 towards(direction_from({radians(-50.0), radians(55.0)}));
  const Shape disc = lathe({{0.0, 0.0}, {radius, 0.0}}, 12);
  const DVec3 axis = glm::normalize(glm::cross(DVec3(0, 1, 0), towards));
  const double tilt_deg = degrees(std::acos(towards.y));
  add_object(model, "Sun", {{m.sun, moved(turned(disc, tilt_deg, axis), distance * towards)}});
}

}  // namespace

Model make_arcade() {
  Model model;
  const Materials materials = add_materials(model);
  add_shell(model, materials);
  add_arches(model, materials);
  add_columns(model, materials);
  add_balustrade(model, materials);
  add_doors(model, materials);
  add_fountain(model, materials);
  add_urn(model, materials);
  add_plants(model, materials);
  add_cloths(model, materials);
  add_sun(model, materials);
  model.cameras.push_back({"Court", {-4.0F, 1.5F, 1.0F}, {radians(78.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
