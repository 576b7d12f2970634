#include <cmath>
#include <numbers>

#include "scenes/builtin.h"
#include "scenes/modelling/patterns.h"
#include "scenes/modelling/props.h"
#include "scenes/studio_car/car.h"

namespace foveola::scenes {
namespace {

constexpr double half_room = 8.0;
constexpr double ceiling = 5.5;
constexpr double turntable_height = 0.06;
constexpr double sweep_turn_deg = 50.0;  ///< the backdrop stands across the camera's view

struct Materials {
  int concrete = 0;
  int brick = 0;
  int ceiling = 0;
  int backdrop = 0;
  int turntable = 0;
  int steel = 0;
  int black = 0;
  int red_lacquer = 0;
  int aluminium = 0;
  int wood = 0;
  int softbox = 0;
  int warm_softbox = 0;
  PlantMaterials plant;
  CarMaterials car;
};

CarMaterials add_car_materials(Model& model) {
  CarMaterials m;
  m.paint = add_material(model, {.name = "metallic paint",
                                 .base_color = {0.1F, 0.22F, 0.5F},
                                 .metallic = 0.75F,
                                 .roughness = 0.28F,
                                 .double_sided = true});
  m.glass =
      add_material(model, {.name = "dark glass", .base_color = Rgb(0.015F), .roughness = 0.06F});
  m.rubber = add_material(model, {.name = "rubber", .base_color = Rgb(0.025F), .roughness = 0.75F});
  m.alloy = add_material(
      model, {.name = "alloy", .base_color = Rgb(0.72F), .metallic = 1.0F, .roughness = 0.3F});
  m.chrome = add_material(
      model, {.name = "chrome", .base_color = Rgb(0.8F), .metallic = 1.0F, .roughness = 0.12F});
  m.black_plastic =
      add_material(model, {.name = "black plastic", .base_color = Rgb(0.02F), .roughness = 0.5F});
  m.headlight = add_material(model, {.name = "headlight",
                                     .base_color = Rgb(0.6F),
                                     .roughness = 0.08F,
                                     .emission = {0.3F, 0.3F, 0.27F}});
  m.tail_light = add_material(
      model, {.name = "tail light", .base_color = {0.4F, 0.01F, 0.01F}, .roughness = 0.1F});
  return m;
}

Materials add_materials(Model& model) {
  Materials m;
  m.concrete =
      add_textured_material(model, "concrete", plaster(512, {0.38F, 0.37F, 0.35F}, 0.35, 31), 0.7F);
  m.brick = add_textured_material(model, "painted brick",
                                  masonry(512,
                                          {.courses = 16,
                                           .stones = 6,
                                           .joint = 0.1,
                                           .variation = 0.08,
                                           .stone = {0.66F, 0.65F, 0.61F},
                                           .mortar = {0.42F, 0.41F, 0.39F}},
                                          32),
                                  0.85F);
  m.ceiling = add_textured_material(model, "ceiling", plaster(256, Rgb(0.5F), 0.1, 33), 0.95F);
  m.backdrop = add_material(model, {.name = "backdrop",
                                    .base_color = {0.62F, 0.6F, 0.57F},
                                    .roughness = 0.9F,
                                    .double_sided = true});
  m.turntable =
      add_material(model, {.name = "turntable", .base_color = Rgb(0.16F), .roughness = 0.35F});
  m.steel = add_material(
      model, {.name = "steel", .base_color = Rgb(0.55F), .metallic = 1.0F, .roughness = 0.35F});
  m.black = add_material(model, {.name = "black cloth", .base_color = Rgb(0.03F)});
  m.red_lacquer = add_material(
      model, {.name = "red lacquer", .base_color = {0.5F, 0.03F, 0.02F}, .roughness = 0.25F});
  m.aluminium = add_material(
      model, {.name = "aluminium", .base_color = Rgb(0.8F), .metallic = 1.0F, .roughness = 0.45F});
  m.wood = add_textured_material(
      model, "wood", wood(512, 6, {0.4F, 0.25F, 0.13F}, {0.22F, 0.12F, 0.06F}, 34), 0.5F);
  m.softbox = add_material(model, {.name = "softbox", .emission = Rgb(13.0F)});
  m.warm_softbox = add_material(model, {.name = "warm softbox", .emission = {14.0F, 11.5F, 9.0F}});
  m.plant = add_plant_materials(model);
  m.car = add_car_materials(model);
  return m;
}

void add_shell(Model& model, const Materials& m) {
  const DVec3 x(2.0 * half_room, 0.0, 0.0);
  const DVec3 y(0.0, ceiling, 0.0);
  const DVec3 z(0.0, 0.0, 2.0 * half_room);
  const DVec3 corner(-half_room, 0.0, -half_room);
  add_object(model, "Floor", {{m.concrete, with_uv_scale(rectangle(corner + z, x, -z), 0.25)}});
  add_object(model, "Ceiling", {{m.ceiling, with_uv_scale(rectangle(corner + y, x, z), 0.25)}});
  Shape walls = rectangle(corner, x, y);
  append(walls, rectangle(corner + x + z, -x, y));
  append(walls, rectangle(corner + z, -z, y));
  append(walls, rectangle(corner + x, z, y));
  add_object(model, "Walls", {{m.brick, with_uv_scale(walls, 0.6)}});
  Shape truss;
  for (int i = -2; i <= 2; ++i) {
    const double at = 3.0 * i;
    for (const double height : {ceiling - 0.55, ceiling - 0.25}) {
      append(truss, tube({{-half_room, height, at}, {half_room, height, at}}, 0.03, 10));
    }
    for (int k = 0; k < 32; ++k) {
      const double from = -half_room + 0.5 * k;
      const double low = ceiling - 0.55;
      append(truss, tube({{from, low, at}, {from + 0.25, low + 0.3, at}}, 0.012, 6));
      append(truss, tube({{from + 0.25, low + 0.3, at}, {from + 0.5, low, at}}, 0.012, 6));
    }
  }
  add_object(model, "Truss", {{m.steel, truss}});
}

/// A sheet that runs along the floor and sweeps up behind the car.
void add_backdrop(Model& model, const Materials& m) {
  constexpr double width = 9.0;
  constexpr double near_edge = 3.1;
  constexpr double bend_from = -3.0;
  constexpr double bend_radius = 1.6;
  constexpr double height = 4.2;
  std::vector<DVec2> profile = {{near_edge, 0.004}};
  constexpr int steps = 24;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 0.5 * std::numbers::pi * i / steps;
    profile.emplace_back(bend_from - bend_radius * std::sin(angle),
                         0.004 + bend_radius * (1.0 - std::cos(angle)));
  }
  profile.emplace_back(bend_from - bend_radius, height);
  const int rows = static_cast<int>(profile.size()) - 1;
  const Shape sheet = patch(1, rows, [&](double u, double v) {
    const DVec2& at = profile[static_cast<std::size_t>(std::lround(v * rows))];
    return DVec3((u - 0.5) * width, at.y, at.x);
  });
  const Shape roll =
      moved(tube({{-0.5 * width - 0.2, height, 0.0}, {0.5 * width + 0.2, height, 0.0}}, 0.09, 16),
            {0.0, 0.0, bend_from - bend_radius - 0.1});
  add_object(model, "Backdrop",
             {{m.backdrop, turned(sheet, sweep_turn_deg), 40.0},
              {m.aluminium, turned(roll, sweep_turn_deg), 50.0}});
}

/// Moves what faces +Z to `position` and turns it towards `target`.
DMat4 facing(const DVec3& position, const DVec3& target) {
  const DVec3 z = glm::normalize(target - position);
  const DVec3 helper = std::abs(z.y) < 0.99 ? DVec3(0, 1, 0) : DVec3(1, 0, 0);
  const DVec3 x = glm::normalize(glm::cross(helper, z));
  const DVec3 y = glm::cross(z, x);
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(position, 1.0)};
}

struct Softbox {
  const char* name;
  int material;
  double width;
  double height;
  DVec3 position;
  DVec3 target;
};

void add_softbox(Model& model, const Materials& m, const Softbox& softbox) {
  const double w = 0.5 * softbox.width;
  const double h = 0.5 * softbox.height;
  const Shape glow = rectangle({-w, -h, 0.002}, {2.0 * w, 0.0, 0.0}, {0.0, 2.0 * h, 0.0});
  Shape housing = box({-w, -h, -0.12}, {w, h, 0.0});
  for (const double side : {-1.0, 1.0}) {
    append(housing, moved(box(DVec3(2.0 * w + 0.08, 0.04, 0.2)), {0.0, side * (h + 0.02), -0.02}));
    append(housing, moved(box(DVec3(0.04, 2.0 * h, 0.2)), {side * (w + 0.02), 0.0, -0.02}));
  }
  append(housing, moved(turned(cone(0.4, 0.12, 0.35, 24), -90.0, {1, 0, 0}), {0.0, 0.0, -0.1}));
  const DMat4 pose = facing(softbox.position, softbox.target);
  add_object(model, softbox.name,
             {{softbox.material, transformed(glow, pose)}, {m.black, transformed(housing, pose)}});
}

void add_stand(Model& model, const Materials& m, const char* name, const DVec3& top) {
  Shape stand = tube({{top.x, 0.3, top.z}, top}, 0.02, 12);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 3.0;
    const DVec3 foot(top.x + 0.55 * std::sin(angle), 0.02, top.z + 0.55 * std::cos(angle));
    append(stand, tube({{top.x, 0.75, top.z}, foot}, 0.012, 8));
  }
  add_object(model, name, {{m.steel, stand}});
}

void add_softboxes(Model& model, const Materials& m) {
  const DVec3 car(0.0, 0.7, 0.0);
  add_softbox(model, m,
              {"Overhead softbox", m.softbox, 1.7, 4.4, {0.0, 4.5, 0.0}, {0.0, 0.0, 0.0}});
  const DVec3 key(5.0, 2.4, -2.4);
  add_softbox(model, m, {"Key softbox", m.softbox, 1.3, 2.2, key, car});
  add_stand(model, m, "Key stand", key - DVec3(-0.25, 0.1, 0.12));
  const DVec3 fill(-3.6, 2.2, 4.8);
  add_softbox(model, m, {"Fill softbox", m.warm_softbox, 1.6, 2.2, fill, car});
  add_stand(model, m, "Fill stand", fill - DVec3(0.19, 0.1, -0.25));
  const DVec3 back(5.5, 3.0, 6.2);
  add_softbox(model, m, {"Room softbox", m.warm_softbox, 1.4, 1.4, back, {1.0, 0.3, 1.0}});
  add_stand(model, m, "Room stand", back + DVec3(0.2, -0.1, 0.2));
}

/// A workshop trolley with drawers that stands on the origin and faces +Z.
void add_trolley(Model& model, const Materials& m, const DVec3& place, double turn_deg) {
  const auto put = [&](const Shape& shape) { return moved(turned(shape, turn_deg), place); };
  const Shape body = moved(rounded_box({0.76, 0.72, 0.46}, 0.02, 2), {0.0, 0.5, 0.0});
  Shape metal;
  for (int i = 0; i < 5; ++i) {
    const double y = 0.24 + 0.13 * i;
    append(metal, moved(box(DVec3(0.68, 0.012, 0.03)), {0.0, y + 0.09, 0.235}));
  }
  append(metal, tube({{-0.38, 0.8, -0.1}, {-0.5, 0.84, -0.1}, {-0.5, 0.84, 0.1}, {-0.38, 0.8, 0.1}},
                     0.014, 10));
  Shape wheels;
  for (const double x : {-0.3, 0.3}) {
    for (const double z : {-0.17, 0.17}) {
      append(wheels, moved(turned(cylinder(0.07, 0.04, 24), 90.0, {0, 0, 1}), {x, 0.07, z}));
    }
  }
  append(wheels, moved(rounded_box({0.74, 0.03, 0.44}, 0.01, 2), {0.0, 0.87, 0.0}));
  add_object(model, "Tool trolley",
             {{m.red_lacquer, put(body), 50.0},
              {m.aluminium, put(metal)},
              {m.car.rubber, put(wheels), 50.0}});
}

void add_furnishing(Model& model, const Materials& m) {
  const Shape disc = lathe({{2.95, 0.0}, {2.95, turntable_height}, {0.0, turntable_height}}, 128);
  add_object(model, "Turntable", {{m.turntable, disc}});
  Shape tyres;
  for (int i = 0; i < 4; ++i) {
    append(tyres, moved(tyre(), {0.03 * std::sin(2.1 * i), 0.215 * i, 0.03 * std::cos(3.3 * i)}));
  }
  add_object(model, "Tyre stack", moved({{m.car.rubber, tyres, 35.0}}, {-1.6, 0.01, 2.95}));
  add_trolley(model, m, {2.7, 0.006, -2.9}, 20.0);
  for (int i = 0; i < 3; ++i) {
    const DVec3 place(6.9, 0.0, -1.0 + 1.3 * i);
    const double height = 0.5 + 0.2 * i;
    const Shape flight_case =
        moved(rounded_box({0.7, height, 1.0}, 0.03, 2), {0.0, 0.5 * height, 0.0});
    const Shape band = moved(rounded_box({0.72, 0.04, 1.02}, 0.01, 2), {0.0, 0.7 * height, 0.0});
    add_object(model, "Flight case " + std::to_string(i + 1),
               moved({{m.black, flight_case, 50.0}, {m.aluminium, band, 50.0}}, place));
  }
  Shape bench = moved(rounded_box({3.0, 0.06, 0.8}, 0.02, 2), {0.0, 0.88, 0.0});
  for (const double x : {-1.35, 1.35}) {
    append(bench, moved(box(DVec3(0.08, 0.85, 0.7)), {x, 0.425, 0.0}));
  }
  add_object(model, "Workbench",
             {{m.wood, moved(with_uv_scale(bench, 0.7), {1.5, 0.0, half_room - 0.5})}});
  const DVec3 door(-half_room, 0.0, 3.5);
  Shape slats;
  for (int i = 0; i < 20; ++i) {
    append(slats, moved(box(DVec3(0.06, 0.145, 3.4)), door + DVec3(0.03, 0.075 + 0.15 * i, 1.7)));
  }
  add_object(model, "Rolling door", {{m.aluminium, slats}});
  const PlantSize plant{
      .pot_radius = 0.3, .pot_height = 0.5, .stem_height = 1.0, .leaf_length = 0.4};
  add_object(model, "Plant", moved(potted_plant(plant, m.plant, 400), {7.1, 0.0, 4.2}));
}

}  // namespace

Model make_studio_car() {
  Model model;
  const Materials materials = add_materials(model);
  add_shell(model, materials);
  add_backdrop(model, materials);
  add_softboxes(model, materials);
  add_furnishing(model, materials);
  add_car(model, materials.car, turntable_height);
  model.cameras.push_back({"Three-quarter view", {3.9F, 1.45F, 3.3F}, {radians(-48.0), 0.0}});
  return model;
}

}  // namespace foveola::scenes
