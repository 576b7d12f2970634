// What hangs on and stands along the meeting room's walls, and under its ceiling.
#include <cmath>
#include <numbers>

#include "scenes/meeting_room/parts.h"
#include "scenes/modelling/palm.h"

namespace foveola::scenes::meeting {
namespace {

/// A frame of four bevelled bars around a rectangle in the plane z = 0, facing +Z.
Shape picture_frame(double width, double height, double bar, double depth) {
  Shape frame;
  for (const double side : {-1.0, 1.0}) {
    append(frame, moved(rounded_box({width + 2.0 * bar, bar, depth}, 0.3 * bar, 3),
                        {0.0, side * 0.5 * (height + bar), 0.5 * depth}));
    append(frame, moved(rounded_box({bar, height + 0.02, 0.96 * depth}, 0.3 * bar, 3),
                        {side * 0.5 * (width + bar), 0.0, 0.48 * depth}));
  }
  return frame;
}

/// A framed picture with a mount, about the origin in the plane z = 0, facing +Z.
std::vector<Part> framed_picture(const Materials& m, int image, double width, double height) {
  constexpr double mount = 0.09;
  const DVec3 half(0.5 * width, 0.5 * height, 0.0);
  const Shape inner = picture(DVec3(-half.x, -half.y, 0.014), {width, 0, 0}, {0, height, 0});
  const Shape board =
      moved(box(DVec3(width + 2.0 * mount, height + 2.0 * mount, 0.012)), {0.0, 0.0, 0.006});
  return {{image, inner},
          {m.paper, board},
          {m.dark_wood, picture_frame(width + 2.0 * mount, height + 2.0 * mount, 0.035, 0.032)}};
}

std::vector<Part> placed(std::vector<Part> parts, const DVec3& place, double turn_deg) {
  for (Part& part : parts) {
    part.shape = moved(turned(part.shape, turn_deg), place);
  }
  return parts;
}

/// A marker that lies along X on y = 0: its body, and its cap in colour.
struct Marker {
  Shape body;
  Shape cap;
};

Marker make_marker() {
  const auto lying = [](const Shape& shape) {
    return moved(turned(shape, 90.0, {0, 0, 1}), {0.06, 0.0085, 0.0});
  };
  return {lying(moved(cylinder(0.008, 0.075, 14), {0.0, 0.045, 0.0})),
          lying(lathe({{0.0, 0.0}, {0.007, 0.0}, {0.0082, 0.003}, {0.0085, 0.045}, {0.0, 0.0455}},
                      14))};
}

}  // namespace

void add_whiteboard(Model& model, const Materials& m) {
  constexpr double width = 3.2;
  constexpr double height = 1.6;
  const DVec3 middle(half_x, 1.75, 0.0);
  const auto put = [&](const Shape& shape) { return moved(turned(shape, -90.0), middle); };
  const Shape face = picture({-0.5 * width, -0.5 * height, 0.03}, {width, 0, 0}, {0, height, 0});
  Shape metal = moved(box(DVec3(width, height, 0.028)), {0.0, 0.0, 0.014});
  append(metal, picture_frame(width, height, 0.03, 0.042));
  append(metal,
         moved(rounded_box({1.6, 0.014, 0.09}, 0.005, 2), {0.0, -0.5 * height - 0.03, 0.06}));
  append(metal,
         moved(rounded_box({1.6, 0.022, 0.01}, 0.004, 2), {0.0, -0.5 * height - 0.02, 0.102}));
  Shape plastic;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      append(plastic, moved(rounded_box({0.07, 0.07, 0.048}, 0.014, 3),
                            {x * (0.5 * width + 0.008), y * (0.5 * height + 0.008), 0.024}));
    }
  }
  append(plastic,
         moved(rounded_box({0.13, 0.035, 0.05}, 0.008, 2), {0.45, -0.5 * height - 0.006, 0.06}));
  std::vector<Part> parts = {
      {m.board, put(face)}, {m.aluminium, put(metal)}, {m.black_plastic, put(plastic)}};
  const Marker marker = make_marker();
  double x = -0.6;
  for (const int color : {m.black_plastic, m.blue, m.red, m.green}) {
    const DVec3 place(x, -0.5 * height - 0.023, 0.06);
    parts.push_back({m.white_plastic, put(moved(marker.body, place))});
    parts.push_back({color, put(moved(marker.cap, place))});
    const Shape magnet = turned(
        lathe({{0.018, 0.0}, {0.017, 0.006}, {0.013, 0.009}, {0.0, 0.0095}}, 20), 90.0, {1, 0, 0});
    parts.push_back({color, put(moved(magnet, {1.12 + 0.25 * x, 0.7, 0.03})), 50.0});
    x += 0.19;
  }
  add_object(model, "Whiteboard", parts);
}

void add_flip_chart(Model& model, const Materials& m) {
  constexpr double width = 0.7;
  constexpr double height = 0.93;
  const Shape sheet = picture({-0.5 * width, 0.0, 0.016}, {width, 0, 0}, {0, height, 0});
  const Shape block = moved(box(DVec3(width, height, 0.015)), {0.0, 0.5 * height, 0.0075});
  Shape metal = moved(rounded_box({width + 0.02, 1.0, 0.014}, 0.005, 2), {0.0, 0.46, -0.008});
  append(metal, moved(rounded_box({width, 0.04, 0.03}, 0.008, 2), {0.0, height - 0.01, 0.012}));
  append(metal, moved(rounded_box({width, 0.012, 0.06}, 0.004, 2), {0.0, -0.02, 0.03}));
  const auto lean = [](const Shape& shape) {
    return moved(turned(shape, -10.0, {1, 0, 0}), {0.0, 0.92, 0.0});
  };
  Shape legs;
  for (const double side : {-1.0, 1.0}) {
    append(legs,
           tube({{side * 0.42, 0.01, 0.2}, {side * 0.3, 0.95, -0.02}, {side * 0.2, 1.75, -0.19}},
                0.012, 10));
  }
  append(legs, tube({{0.0, 0.01, -0.62}, {0.0, 1.75, -0.19}}, 0.012, 10));
  append(legs, tube({{-0.22, 1.75, -0.19}, {0.22, 1.75, -0.19}}, 0.012, 10));
  append(legs, lean(metal));
  add_object(model, "Flip chart",
             placed({{m.flip_chart, lean(sheet)}, {m.paper, lean(block)}, {m.aluminium, legs}},
                    {5.0, 0.0, 2.5}, -88.0));
}

void add_wall_things(Model& model, const Materials& m) {
  constexpr double wall = -half_z;
  Shape rim = lathe({{0.34, 0.0},
                     {0.375, 0.0},
                     {0.385, 0.02},
                     {0.38, 0.045},
                     {0.36, 0.055},
                     {0.35, 0.05},
                     {0.345, 0.03},
                     {0.0, 0.03}},
                    64);
  rim = turned(rim, 90.0, {1, 0, 0});
  Shape face = patch(64, 1, [](double u, double v) {
    const double angle = 2.0 * std::numbers::pi * u;
    return 0.347 * (1.0 - v) * DVec3(std::cos(angle), std::sin(angle), 0.0);
  });
  face = with_projected_uvs(face, {1.0 / 0.7, 0, 0}, {0, -1.0 / 0.7, 0});
  for (DVec2& uv : face.uvs) {
    uv += DVec2(0.5);
  }
  add_object(model, "Clock",
             placed({{m.clock, moved(face, {0.0, 0.0, 0.034})}, {m.black_plastic, rim, 50.0}},
                    {-3.65, 2.1, wall}, 0.0));
  add_object(model, "Picture 1",
             placed(framed_picture(m, m.picture, 1.0, 0.75), {1.8, 1.75, wall}, 0.0));
  add_object(model, "Picture 2",
             placed(framed_picture(m, m.abstract_picture, 1.0, 0.75), {4.2, 1.75, wall}, 0.0));
  add_object(model, "Large picture",
             placed(framed_picture(m, m.abstract_picture, 1.6, 1.2), {-half_x, 1.95, 1.6}, 90.0));
  // Sockets above the skirting, and a waste bin by the door.
  Shape sockets;
  for (const double x : {-5.0, -2.0, 0.6, 3.0, 5.4}) {
    append(sockets, moved(rounded_box({0.15, 0.08, 0.014}, 0.005, 2), {x, 0.3, wall + 0.005}));
    for (const double side : {-1.0, 1.0}) {
      append(sockets, moved(turned(torus(0.02, 0.004, 20, 6), 90.0, {1, 0, 0}),
                            {x + side * 0.037, 0.3, wall + 0.012}));
    }
  }
  add_object(model, "Sockets", {{m.white_plastic, sockets}});
  const Shape bin = lathe({{0.0, 0.0},
                           {0.105, 0.0},
                           {0.11, 0.005},
                           {0.135, 0.33},
                           {0.139, 0.336},
                           {0.135, 0.34},
                           {0.13, 0.334},
                           {0.105, 0.012},
                           {0.0, 0.01}},
                          40);
  add_object(model, "Waste bin", {{m.grey_plastic, moved(bin, {-5.7, 0.0, -0.55}), 50.0}});
}

void add_cabinet(Model& model, const Materials& m) {
  constexpr double height = 0.9;
  constexpr double depth = 0.5;
  constexpr double length = 2.8;
  constexpr int doors = 4;
  const DVec3 place(-half_x + 0.02, 0.0, 1.6);
  const auto put = [&](const Shape& shape) { return moved(turned(shape, 90.0), place); };
  Shape body = moved(box(DVec3(length - 0.02, height - 0.1, depth - 0.04)),
                     {0.0, 0.5 * height + 0.03, 0.5 * depth - 0.02});
  append(body,
         moved(box(DVec3(length - 0.1, 0.09, depth - 0.1)), {0.0, 0.045, 0.5 * depth - 0.05}));
  append(body, moved(rounded_box({length + 0.02, 0.03, depth + 0.02}, 0.008, 3),
                     {0.0, height - 0.012, 0.5 * depth}));
  Shape fronts;
  Shape handles;
  for (int i = 0; i < doors; ++i) {
    const double x = length / doors * (i - 0.5 * (doors - 1));
    append(fronts, moved(rounded_box({length / doors - 0.006, height - 0.13, 0.022}, 0.003, 2),
                         {x, 0.5 * height + 0.032, depth - 0.03}));
    const double handle_x = x + (i % 2 == 0 ? 0.29 : -0.29);
    append(handles, tube({{handle_x, 0.62, depth - 0.02},
                          {handle_x, 0.62, depth + 0.012},
                          {handle_x, 0.63, depth + 0.016},
                          {handle_x, 0.79, depth + 0.016},
                          {handle_x, 0.8, depth + 0.012},
                          {handle_x, 0.8, depth - 0.02}},
                         0.005, 10));
  }
  add_object(
      model, "Cabinet",
      {{m.dark_wood, put(body)}, {m.light_wood, put(fronts)}, {m.chrome, put(handles), 50.0}});
  // On it: a tray with cups and jugs, a coffee machine, a pile of folders, a plant.
  const DVec3 top(0.0, height + 0.003, 0.0);
  const auto stand = [&](const Shape& shape, double x, double z, double turn_deg) {
    return put(moved(turned(shape, turn_deg), top + DVec3(x, 0.0, z)));
  };
  Shape tray = moved(rounded_box({0.66, 0.012, 0.34}, 0.005, 2), {0.0, 0.006, 0.0});
  const Cup cup = make_cup();
  Shape cups;
  for (int i = 0; i < 8; ++i) {
    append(cups, stand(moved(cup.porcelain, {0.0, 0.012, 0.0}), 0.155 * (i % 4) - 0.93,
                       0.165 + 0.155 * (i / 4), 40.0 * i));
  }
  Shape machine = moved(rounded_box({0.26, 0.36, 0.36}, 0.025, 3), {0.0, 0.18, -0.02});
  append(machine, moved(rounded_box({0.22, 0.09, 0.12}, 0.015, 3), {0.0, 0.3, 0.2}));
  append(machine, moved(rounded_box({0.24, 0.03, 0.16}, 0.01, 2), {0.0, 0.016, 0.22}));
  Shape spouts = moved(cylinder(0.01, 0.05, 14), {-0.03, 0.21, 0.22});
  append(spouts, moved(cylinder(0.01, 0.05, 14), {0.03, 0.21, 0.22}));
  append(spouts, moved(turned(torus(0.03, 0.005, 28, 8), 90.0, {1, 0, 0}), {0.0, 0.305, 0.261}));
  Shape folders;
  double y = 0.0;
  for (int i = 0; i < 6; ++i) {
    const double thickness = 0.02 + 0.008 * (i % 3);
    append(folders, moved(turned(rounded_box({0.24, thickness - 0.001, 0.31}, 0.004, 1),
                                 9.0 * std::sin(2.6 * i)),
                          {0.0, y + 0.5 * thickness, 0.0}));
    y += thickness;
  }
  const PlantSize fern{.pot_radius = 0.11,
                       .pot_height = 0.16,
                       .stem_height = 0.22,
                       .leaf_length = 0.16,
                       .stems = 10,
                       .leaves_per_stem = 6};
  add_object(model, "Coffee tray",
             {{m.aluminium, stand(tray, -0.7, 0.243, 0.0)},
              {m.porcelain, cups, 50.0},
              {m.chrome, stand(make_jug(), -0.25, 0.25, 120.0), 50.0}});
  add_object(model, "Coffee machine",
             {{m.black_plastic, stand(machine, 0.15, 0.22, 0.0)},
              {m.chrome, stand(spouts, 0.15, 0.22, 0.0), 50.0}});
  add_object(model, "Folders", {{m.blue, stand(folders, 0.62, 0.27, 8.0)}});
  add_object(model, "Cabinet plant",
             placed(potted_plant(fern, m.plant, model.stream(303)),
                    place + DVec3(0.26, top.y, -1.12), 0.0));
}

void add_plants(Model& model, const Materials& m) {
  const PlantSize tall{.pot_radius = 0.28,
                       .pot_height = 0.5,
                       .stem_height = 1.15,
                       .leaf_length = 0.36,
                       .stems = 13,
                       .leaves_per_stem = 8};
  add_object(model, "Tall plant",
             moved(potted_plant(tall, m.plant, model.stream(300)), {-1.2, 0.0, -half_z + 0.65}));
  const PalmSize palm{.pot_radius = 0.26, .pot_height = 0.45, .frond_length = 1.1, .fronds = 15};
  add_object(
      model, "Corner plant",
      moved(potted_palm(palm, m.plant, model.stream(301)), {half_x - 0.95, 0.0, -half_z + 0.95}));
  const PlantSize small{
      .pot_radius = 0.11, .pot_height = 0.14, .stem_height = 0.24, .leaf_length = 0.17};
  add_object(model, "Table plant",
             moved(potted_plant(small, m.plant, model.stream(302)), {0.15, table_height, 0.0}));
}

void add_projector(Model& model, const Materials& m) {
  const DVec3 place(1.4, ceiling - 0.5, 0.0);
  Shape projector = rounded_box({0.36, 0.13, 0.42}, 0.035, 4);
  append(projector, moved(lathe({{0.09, -0.02},
                                 {0.09, -0.008},
                                 {0.028, 0.0},
                                 {0.028, 0.4},
                                 {0.1, 0.41},
                                 {0.11, 0.418},
                                 {0.11, 0.435}},
                                32),
                          {0.0, 0.066, 0.0}));
  // Towards the whiteboard: the lens in its ring; on the sides slots for air.
  Shape dark = moved(turned(lathe({{0.035, -0.01},
                                   {0.06, -0.01},
                                   {0.06, 0.02},
                                   {0.05, 0.03},
                                   {0.045, 0.01},
                                   {0.035, 0.005}},
                                  36),
                            -90.0, {0, 0, 1}),
                     {0.18, 0.0, 0.09});
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 9; ++i) {
      append(dark, moved(box(DVec3(0.012, 0.06, 0.004)), {0.026 * (i - 4), 0.0, side * 0.2095}));
    }
  }
  const Shape lens =
      moved(scaled(ellipsoid(DVec3(0.045), 24), {0.35, 1.0, 1.0}), {0.18, 0.0, 0.09});
  add_object(
      model, "Projector",
      moved({{m.white_plastic, projector}, {m.black_plastic, dark}, {m.grey_plastic, lens, 60.0}},
            place));
}

}  // namespace foveola::scenes::meeting
