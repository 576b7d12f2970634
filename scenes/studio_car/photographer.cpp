// What the photographer works with: camera, desk, ladder.
#include <cmath>
#include <numbers>

#include "scenes/modelling/curve.h"
#include "scenes/studio_car/pose.h"
#include "scenes/studio_car/studio.h"

namespace foveola::scenes::studio {
namespace {

/// A camera about the middle of its body, its lens towards +Z.
struct CameraParts {
  Shape body;
  Shape lens;
  Shape glass;
};

CameraParts camera_parts() {
  CameraParts parts;
  parts.body = rounded_box({0.15, 0.1, 0.06}, 0.018, 4);
  append(parts.body, moved(rounded_box({0.06, 0.035, 0.065}, 0.012, 4), {0.0, 0.06, 0.0}));
  append(parts.body, moved(rounded_box({0.035, 0.095, 0.035}, 0.015, 4), {-0.06, -0.002, 0.032}));
  for (const double x : {-0.058, 0.05}) {
    append(parts.body, moved(lathe({{0.0, 0.0},
                                    {0.013, 0.0},
                                    {0.014, 0.002},
                                    {0.014, 0.011},
                                    {0.012, 0.013},
                                    {0.0, 0.013}},
                                   32),
                             {x, 0.046, 0.005}));
  }
  std::vector<DVec2> barrel = {{0.034, 0.0}, {0.036, 0.002}, {0.036, 0.02}};
  for (int i = 0; i < 14; ++i) {
    const double at = 0.022 + 0.003 * i;
    barrel.insert(barrel.end(), {{0.0375, at}, {0.0375, at + 0.0015}, {0.0365, at + 0.002}});
  }
  barrel.insert(barrel.end(), {{0.037, 0.066},
                               {0.041, 0.07},
                               {0.041, 0.105},
                               {0.039, 0.107},
                               {0.036, 0.105},
                               {0.034, 0.09},
                               {0.0, 0.088}});
  const auto ahead = [](const Shape& shape) {
    return moved(turned(shape, 90.0, {1, 0, 0}), {0.0, 0.0, 0.028});
  };
  parts.lens = ahead(lathe(barrel, 56));
  parts.glass = ahead(moved(ellipsoid({0.032, 0.01, 0.032}, 40), {0.0, 0.09, 0.0}));
  return parts;
}

}  // namespace

void add_camera(Model& model, const Materials& m, const DVec3& place) {
  constexpr double height = 1.28;
  const DVec3 neck = place + DVec3(0.0, height - 0.2, 0.0);
  Shape legs;
  Shape joints = moved(
      lathe({{0.0, -0.04}, {0.04, -0.04}, {0.05, -0.03}, {0.05, 0.03}, {0.04, 0.04}, {0.0, 0.04}},
            36),
      neck);
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 3.0 + 0.4;
    const DVec3 out(std::sin(angle), 0.0, std::cos(angle));
    const DVec3 from = neck + 0.04 * out;
    const DVec3 to = place + 0.52 * out + DVec3(0.0, 0.014, 0.0);
    const auto at = [&](double t) { return (1.0 - t) * from + t * to; };
    append(legs, tube({at(0.0), at(0.42)}, 0.015, 20));
    append(legs, tube({at(0.4), at(0.75)}, 0.012, 20));
    append(legs, tube({at(0.73), to}, 0.009, 20));
    append(joints, tube({at(0.38), at(0.43)}, 0.0185, 20));
    append(joints, tube({at(0.72), at(0.76)}, 0.0155, 20));
    append(joints, moved(ellipsoid({0.016, 0.014, 0.016}, 20), to));
  }
  append(legs, tube({neck, neck + DVec3(0.0, 0.11, 0.0)}, 0.014, 20));
  append(joints, moved(ellipsoid(DVec3(0.026), 28), neck + DVec3(0.0, 0.11, 0.0)));
  append(joints, moved(rounded_box({0.06, 0.012, 0.06}, 0.004, 3), neck + DVec3(0.0, 0.143, 0.0)));
  append(joints, tube({neck + DVec3(0.0, 0.1, 0.0), neck + DVec3(0.1, 0.02, 0.22)}, 0.008, 12));
  const CameraParts camera = camera_parts();
  const DVec3 middle = neck + DVec3(0.0, 0.199, 0.0);
  const DMat4 pose = facing(middle, DVec3(0.4, 0.7, 0.3) - middle);
  add_object(model, "Camera",
             {{m.aluminium, legs, 45.0},
              {m.black_steel, joints, 45.0},
              {m.camera_body, transformed(camera.body, pose), 45.0},
              {m.camera_body, transformed(camera.lens, pose), 40.0},
              {m.lens, transformed(camera.glass, pose), 60.0}});
}

void add_desk(Model& model, const Materials& m) {
  const DVec3 place(6.6, 0.0, 2.9);
  Shape board = moved(rounded_box({0.7, 0.035, 1.5}, 0.008, 3), {0.0, 0.74, 0.0});
  Shape frame;
  for (const double z : {-0.65, 0.65}) {
    for (const double x : {-0.28, 0.28}) {
      append(frame, tube({{x, 0.0, z}, {x, 0.73, z}}, 0.02, 20));
    }
    append(frame, tube({{-0.28, 0.12, z}, {0.28, 0.12, z}}, 0.014, 16));
  }
  // The monitor's back is to the wall at +X.
  const Shape screen_case = moved(rounded_box({0.03, 0.4, 0.64}, 0.01, 3), {0.12, 1.06, -0.15});
  Shape devices = screen_case;
  append(devices, tube({{0.15, 0.77, -0.15}, {0.15, 1.0, -0.15}}, 0.02, 20));
  append(devices, moved(rounded_box({0.2, 0.015, 0.26}, 0.006, 3), {0.13, 0.766, -0.15}));
  append(devices, moved(rounded_box({0.13, 0.016, 0.42}, 0.005, 3), {-0.16, 0.767, -0.15}));
  Shape keys;
  for (int row = 0; row < 5; ++row) {
    for (int key = 0; key < 15; ++key) {
      append(keys, moved(rounded_box({0.018, 0.008, 0.021}, 0.003, 1),
                         {-0.208 + 0.0235 * row, 0.779, -0.33 + 0.0257 * key}));
    }
  }
  append(keys, moved(ellipsoid({0.055, 0.02, 0.032}, 32), {-0.16, 0.772, 0.16}));
  Shape mug = moved(lathe({{0.0, 0.0},
                           {0.036, 0.0},
                           {0.04, 0.004},
                           {0.041, 0.092},
                           {0.039, 0.094},
                           {0.037, 0.09},
                           {0.036, 0.012},
                           {0.0, 0.01}},
                          40),
                    {-0.1, 0.7575, 0.42});
  append(mug, moved(turned(torus(0.025, 0.005, 32, 10), 90.0, {1, 0, 0}), {-0.065, 0.804, 0.42}));
  const Shape display = picture({0.1045, 0.875, -0.455}, {0.0, 0.0, 0.61}, {0.0, 0.37, 0.0});
  // A stool on a gas spring before it.
  Shape seat = moved(rounded_box({0.38, 0.08, 0.38}, 0.036, 5, 4), {-0.7, 0.52, -0.1});
  Shape base = tube({{-0.7, 0.1, -0.1}, {-0.7, 0.49, -0.1}}, 0.022, 20);
  Shape castors;
  for (int i = 0; i < 5; ++i) {
    const double angle_deg = 72.0 * i;
    append(base, moved(turned(tube({{0.0, 0.12, 0.0}, {0.0, 0.075, 0.27}}, 0.016, 14), angle_deg),
                       {-0.7, 0.0, -0.1}));
    const Castor wheel = castor(0.07);
    append(base, moved(turned(moved(wheel.fork, {0.0, 0.0, 0.25}), angle_deg), {-0.7, 0.0, -0.1}));
    append(castors,
           moved(turned(moved(wheel.wheel, {0.0, 0.0, 0.25}), angle_deg), {-0.7, 0.0, -0.1}));
  }
  add_object(model, "Desk",
             moved({{m.wood, with_uv_scale(board, 0.7), 45.0},
                    {m.black_steel, frame, 45.0},
                    {m.camera_body, devices, 45.0},
                    {m.white_paint, keys, 45.0},
                    {m.red_lacquer, mug, 45.0},
                    {m.display, display}},
                   place));
  add_object(model, "Stool",
             moved({{m.car.leather, with_uv_scale(seat, 2.0), 50.0},
                    {m.car.chrome, base, 45.0},
                    {m.car.rubber, castors, 50.0}},
                   place));
}

void add_ladder(Model& model, const Materials& m, const DVec3& place, double turn_deg) {
  constexpr double height = 2.0;
  constexpr double lean = 0.5;
  Shape aluminium;
  Shape feet;
  for (const double side : {-1.0, 1.0}) {
    const auto leg = [&](double z) {
      append(aluminium,
             tube({{0.24 * side, 0.03, z}, {0.17 * side, height, 0.06 * (z > 0 ? 1.0 : -1.0)}},
                  0.017, 14));
      append(feet, moved(rounded_box({0.05, 0.05, 0.05}, 0.012, 3), {0.24 * side, 0.025, z}));
    };
    leg(lean);
    leg(-lean);
    append(aluminium, tube({{0.215 * side, 0.7, 0.345}, {0.215 * side, 0.7, -0.345}}, 0.006, 10));
  }
  for (int i = 1; i <= 6; ++i) {
    const double t = 0.142 * i;
    const double half = std::lerp(0.24, 0.17, t);
    append(aluminium, moved(rounded_box({2.0 * half, 0.022, 0.085}, 0.008, 3),
                            {0.0, height * t, std::lerp(lean, 0.06, t)}));
    append(aluminium, tube({{-half, height * t, -std::lerp(lean, 0.06, t)},
                            {half, height * t, -std::lerp(lean, 0.06, t)}},
                           0.01, 12));
  }
  Shape top = moved(rounded_box({0.42, 0.05, 0.24}, 0.02, 4), {0.0, height + 0.01, 0.0});
  add_object(
      model, "Ladder",
      placed(
          {{m.aluminium, aluminium, 45.0}, {m.red_lacquer, top, 45.0}, {m.car.rubber, feet, 45.0}},
          turn_deg, place));
}

}  // namespace foveola::scenes::studio
