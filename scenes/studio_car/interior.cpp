#include <algorithm>
#include <cmath>

#include "scenes/studio_car/openings.h"
#include "scenes/studio_car/parts.h"
#include "scenes/studio_car/pose.h"

namespace foveola::scenes::car {
namespace {

constexpr double driver_z = -0.37;

/// A cushion lying on the origin, its bolsters raised along both sides.
Shape cushion(const DVec3& size, double bolster) {
  const Shape block = rounded_box(size, 0.35 * size.y, 3, 9);
  return deformed(block, [&](const DVec3& p) {
    const double out = std::abs(p.z) / (0.5 * size.z);
    const double top = std::max(0.0, p.y / (0.5 * size.y));
    return DVec3(p.x, p.y + 0.5 * size.y + top * bolster * out * out * out, p.z);
  });
}

struct Seat {
  Shape cushions;
  Shape shell;
};

/// A front seat around its cushion's middle, facing +X.
Seat front_seat() {
  Seat seat;
  seat.cushions = turned(cushion({0.52, 0.13, 0.5}, 0.05), 6.0, {0, 0, 1});
  const Shape back = turned(cushion({0.6, 0.11, 0.48}, 0.06), 90.0 + 22.0, {0, 0, 1});
  append(seat.cushions, moved(back, {-0.36, 0.4, 0.0}));
  const Shape head = turned(rounded_box({0.19, 0.1, 0.26}, 0.04, 4, 4), 90.0 + 16.0, {0, 0, 1});
  append(seat.cushions, moved(head, {-0.535, 0.765, 0.0}));
  const Shape back_shell = turned(rounded_box({0.56, 0.04, 0.42}, 0.018, 3), 112.0, {0, 0, 1});
  seat.shell = moved(back_shell, {-0.375, 0.4, 0.0});
  for (const double z : {-0.06, 0.06}) {
    append(seat.shell, tube({{-0.47, 0.6, z}, {-0.54, 0.75, z}}, 0.006, 10));
  }
  append(seat.shell, moved(rounded_box({0.46, 0.12, 0.44}, 0.02, 2), {0.0, -0.05, 0.0}));
  return seat;
}

}  // namespace

std::vector<Part> seats(const CarMaterials& m) {
  Shape cushions;
  Shape shells;
  for (const double z : {driver_z, -driver_z}) {
    const Seat seat = front_seat();
    append(cushions, moved(seat.cushions, {-0.12, 0.34, z}));
    append(shells, moved(seat.shell, {-0.12, 0.34, z}));
  }
  append(cushions, moved(cushion({0.4, 0.13, 1.1}, 0.04), {-0.82, 0.4, 0.0}));
  const Shape back = turned(cushion({0.5, 0.12, 1.06}, 0.04), 90.0 + 34.0, {0, 0, 1});
  append(cushions, moved(back, {-1.05, 0.7, 0.0}));
  return {{m.stitched_leather, cushions, 50.0}, {m.black_plastic, shells, 45.0}};
}

std::vector<Part> steering_wheel(const CarMaterials& m) {
  // Lying around the Y axis, the driver above it, the car's nose below.
  Shape leather = torus(0.182, 0.0155, 96, 18);
  append(leather, ellipsoid({0.062, 0.03, 0.055}, 32));
  Shape spokes;
  for (const double angle_deg : {0.0, 90.0, -90.0}) {
    const Shape bar = moved(rounded_box({0.04, 0.014, 0.14}, 0.006, 3), {0.0, -0.008, 0.11});
    append(spokes, turned(bar, angle_deg));
  }
  append(spokes, moved(torus(0.019, 0.002, 32, 8), {0.0, 0.029, 0.0}));
  const Shape column = moved(cylinder(0.035, 0.22, 24), {0.0, -0.23, 0.0});
  Shape levers;
  for (const double side : {-1.0, 1.0}) {
    append(levers, tube({{0.03 * side, -0.06, 0.0}, {0.15 * side, -0.045, -0.02}}, 0.007, 10));
  }
  const auto put = [](const Shape& shape) {
    // The ring's lower edge, +Z while it lies, points down and back once it stands.
    const Shape to_driver = turned(shape, -90.0);
    return moved(turned(to_driver, 65.0, {0, 0, 1}), {0.3, 0.8, driver_z});
  };
  return {{m.leather, put(leather), 60.0},
          {m.alloy, put(spokes), 50.0},
          {m.black_plastic, put(column), 50.0},
          {m.black_plastic, put(levers), 50.0}};
}

std::vector<Part> dashboard(const CarMaterials& m) {
  const Shape block = rounded_box({0.5, 0.26, 1.52}, 0.07, 4, 10);
  Shape leather =
      moved(deformed(block,
                     [](const DVec3& p) {
                       const double out = std::abs(p.z) / 0.76;
                       return DVec3(p.x - 0.06 * out * out, p.y - 0.05 * out * out * out, p.z);
                     }),
            {0.68, 0.73, 0.0});
  append(leather, moved(ellipsoid({0.15, 0.09, 0.2}, 40), {0.52, 0.83, driver_z}));
  append(leather, moved(rounded_box({1.3, 0.2, 0.22}, 0.05, 4), {-0.05, 0.38, 0.0}));
  Shape trim = moved(rounded_box({0.02, 0.03, 1.4}, 0.008, 2), {0.426, 0.7, 0.0});
  for (const double z : {-0.62, -0.1, 0.1, 0.62}) {
    const Shape vent = turned(torus(0.034, 0.006, 40, 10), 90.0, {0, 0, 1});
    append(trim, moved(vent, {0.424, 0.765, z}));
  }
  append(trim, moved(cylinder(0.022, 0.05, 28), {0.12, 0.47, 0.0}));
  append(trim, moved(cylinder(0.008, 0.14, 16), {0.28, 0.46, 0.0}));
  append(leather, moved(ellipsoid({0.026, 0.032, 0.026}, 24), {0.28, 0.61, 0.0}));
  const Shape screen_frame = turned(rounded_box({0.016, 0.15, 0.27}, 0.006, 3), -8.0, {0, 0, 1});
  const auto screen = [](const DVec3& corner, double height, double width) {
    return picture(corner, {0.0, 0.0, width}, {0.0, height, 0.0});
  };
  Shape screens = moved(turned(screen({-0.0085, -0.065, -0.125}, 0.13, 0.25), -8.0, {0, 0, 1}),
                        {0.44, 0.89, 0.0});
  append(screens, screen({0.366, 0.78, driver_z - 0.1}, 0.09, 0.2));
  const Shape cluster = moved(rounded_box({0.1, 0.12, 0.24}, 0.02, 3), {0.417, 0.825, driver_z});
  return {{m.leather, leather, 50.0},
          {m.alloy, trim, 45.0},
          {m.black_plastic, moved(screen_frame, {0.44, 0.89, 0.0}), 50.0},
          {m.black_plastic, cluster, 50.0},
          {m.screen, screens}};
}

std::vector<Part> cabin_lining(const Body& body, const CarMaterials& m) {
  constexpr double trim_depth = 0.05;
  constexpr double lining_depth = 0.022;
  Shape side_trims = on_both_sides(inside_out(plate(body.door, trim_depth)));
  append(side_trims, on_both_sides(inside_out(plate(body.quarter, trim_depth))));
  Shape arm_rests;
  for (const double z : {-0.76, 0.76}) {
    append(arm_rests, moved(rounded_box({0.7, 0.06, 0.12}, 0.025, 4), {-0.1, 0.6, z}));
  }
  const Cells roof = none_of({is_windscreen(body.cabin_top), is_rear_window(body.cabin_top)});
  Shape lining = inside_out(plate(body.cabin_top, roof, lining_depth));
  const Cells pillars =
      none_of({is_door_window(body.cabin_side), is_quarter_window(body.cabin_side)});
  append(lining, on_both_sides(inside_out(plate(body.cabin_side, pillars, lining_depth))));
  Shape carpet = moved(rounded_box({2.1, 0.08, 1.5}, 0.02, 2), {-0.1, 0.24, 0.0});
  append(carpet, moved(rounded_box({0.5, 0.05, 1.2}, 0.02, 2), {-1.33, 0.88, 0.0}));
  Shape belts;
  for (const double side : {-1.0, 1.0}) {
    append(belts,
           tube({{-0.66, 1.06, 0.6 * side}, {-0.7, 0.6, 0.68 * side}, {-0.62, 0.34, 0.68 * side}},
                0.012, 8));
  }
  return {{m.leather, side_trims, 50.0},
          {m.stitched_leather, arm_rests, 50.0},
          {m.lining, lining, 50.0},
          {m.carpet, carpet, 50.0},
          {m.black_plastic, belts, 60.0}};
}

}  // namespace foveola::scenes::car
