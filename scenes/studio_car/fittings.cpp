#include <cmath>
#include <numbers>

#include "scenes/studio_car/body_surface.h"
#include "scenes/studio_car/openings.h"
#include "scenes/studio_car/parts.h"
#include "scenes/studio_car/pose.h"

namespace foveola::scenes::car {
namespace {

constexpr double plate_width = 0.52;
constexpr double plate_height = 0.11;

/// Tubes along a sheet's rows and columns, `depth` below it, where `cells` allow.
Shape bars(const Sheet& sheet, const Cells& cells, std::size_t row_step, std::size_t column_step,
           double depth, double radius) {
  Shape shape;
  const auto run = [&](std::size_t length, const auto& cell_of, const auto& point_of) {
    std::vector<DVec3> path;
    for (std::size_t i = 0; i <= length; ++i) {
      if (i < length && cell_of(i)) {
        const DVec3& point = point_of(i);
        path.push_back(point - depth * skin_normal(point));
      } else if (!path.empty()) {
        if (path.size() > 1) {
          append(shape, tube(path, radius, 8));
        }
        path.clear();
      }
    }
  };
  for (std::size_t row = row_step / 2; row_step > 0 && row + 1 < sheet.rows; row += row_step) {
    run(
        sheet.columns - 1, [&](std::size_t i) { return cells(i, row); },
        [&](std::size_t i) -> const DVec3& { return sheet.at(i, row); });
  }
  for (std::size_t column = column_step / 2; column_step > 0 && column + 1 < sheet.columns;
       column += column_step) {
    run(
        sheet.rows - 1, [&](std::size_t i) { return cells(column, i); },
        [&](std::size_t i) -> const DVec3& { return sheet.at(column, i); });
  }
  return shape;
}

/// The half pipe over a wheel, closed towards the car's middle.
Shape wheel_house(double axle) {
  constexpr double radius = 0.4;
  constexpr double inner_z = 0.5;
  constexpr double outer_z = 0.83;
  const auto around = [&](double turn, double r, double z) {
    const double angle = radians(std::lerp(-16.0, 196.0, turn));
    return DVec3(axle + r * std::cos(angle), wheel_radius + r * std::sin(angle), z);
  };
  Shape shape = patch(
      72, 8, [&](double u, double v) { return around(u, radius, std::lerp(inner_z, outer_z, v)); });
  append(shape, patch(72, 4, [&](double u, double v) {
           return around(u, std::lerp(0.07, radius, v), inner_z);
         }));
  return shape;
}

std::vector<Part> number_plate(const CarMaterials& m) {
  const double w = 0.5 * plate_width;
  const double h = 0.5 * plate_height;
  const Shape sheet_metal = rounded_box({plate_width, plate_height, 0.006}, 0.0025, 2);
  const Shape frame = moved(rounded_box({plate_width + 0.02, plate_height + 0.02, 0.012}, 0.005, 3),
                            {0.0, 0.0, -0.006});
  Shape screws;
  for (const double x : {-0.19, 0.19}) {
    append(screws, moved(ellipsoid({0.006, 0.006, 0.003}, 16), {x, 0.044, 0.0035}));
  }
  const Shape face =
      picture({-w + 0.003, -h + 0.003, 0.0032}, {2.0 * w - 0.006, 0, 0}, {0, 2.0 * h - 0.006, 0});
  return {{m.black_plastic, frame, 50.0},
          {m.alloy, sheet_metal, 50.0},
          {m.number_plate, face},
          {m.alloy, screws, 50.0}};
}

std::vector<Part> posed(std::vector<Part> parts, const DMat4& pose) {
  for (Part& part : parts) {
    part.shape = transformed(part.shape, pose);
  }
  return parts;
}

Shape wiper(double from_z, double to_z) {
  const auto on_glass = [](double x, double z, double height) {
    const DVec3 point = seen_from_above(x, z);
    return point + height * skin_normal(point);
  };
  std::vector<DVec3> blade;
  for (const double z : even(from_z, to_z, 16)) {
    blade.push_back(on_glass(0.93 - 0.2 * z * z, z, 0.008));
  }
  Shape shape = tube(blade, 0.006, 8);
  const double middle = 0.5 * (from_z + to_z);
  append(shape, tube({on_glass(1.0 - 0.2 * from_z * from_z, from_z, 0.012),
                      on_glass(0.93 - 0.2 * middle * middle, middle, 0.022)},
                     0.005, 8));
  return shape;
}

Shape door_handle() {
  const DVec3 place = seen_from_side(-0.44, 0.745);
  const DVec3 normal = skin_normal(place);
  Shape shape = deformed(rounded_box({0.21, 0.026, 0.022}, 0.009, 4, 10), [](const DVec3& p) {
    const double middle = 1.0 - std::pow(std::abs(p.x) / 0.105, 4.0);
    return p + DVec3(0.0, 0.0, 0.014 * middle);
  });
  return transformed(shape, facing(place + 0.006 * normal, normal));
}

/// An oval tail pipe about the origin, open towards -X.
Shape tail_pipe() {
  const Shape ring = lathe({{0.044, -0.03},
                            {0.05, -0.026},
                            {0.05, 0.1},
                            {0.046, 0.103},
                            {0.043, 0.1},
                            {0.04, 0.0},
                            {0.0, 0.0}},
                           56);
  return scaled(turned(ring, 90.0, {0, 0, 1}), {1.0, 0.8, 1.3});
}

}  // namespace

std::vector<Part> bodywork(const Body& body, const CarMaterials& m) {
  constexpr double fold = 0.02;
  constexpr double arch_fold = 0.045;
  const Cells open_front =
      none_of({is_grille(body.nose), is_air_intake(body.nose), is_headlight(body.nose)});
  const Cells open_rear =
      none_of({is_tail_light(body.tail), is_plate_recess(body.tail), is_diffuser(body.tail)});
  Shape painted = with_folded_edges(plate(body.nose, open_front), fold);
  append(painted, with_folded_edges(plate(body.tail, open_rear), fold));
  append(painted, with_folded_edges(plate(body.bonnet), fold));
  append(painted, with_folded_edges(plate(body.boot_lid), fold));
  append(painted, on_both_sides(with_folded_edges(plate(body.door), fold)));
  append(painted, on_both_sides(with_folded_edges(plate(body.fender), arch_fold)));
  append(painted, on_both_sides(with_folded_edges(plate(body.quarter), arch_fold)));
  const Cells pillars =
      none_of({is_door_window(body.cabin_side), is_quarter_window(body.cabin_side),
               is_middle_pillar(body.cabin_side)});
  append(painted, on_both_sides(with_folded_edges(plate(body.cabin_side, pillars), fold)));
  const Cells roof = none_of({is_windscreen(body.cabin_top), is_rear_window(body.cabin_top)});
  append(painted, with_folded_edges(plate(body.cabin_top, roof), fold));
  const Shape black = on_both_sides(with_folded_edges(plate(body.sill), fold));
  return {{m.paint, painted, 40.0}, {m.gloss_black, black, 40.0}};
}

std::vector<Part> window_panes(const Body& body, const CarMaterials& m) {
  constexpr double sunk = 0.004;
  const Sheet& side = body.cabin_side;
  Shape panes = on_both_sides(plate(side, is_door_window(side), sunk));
  append(panes, on_both_sides(plate(side, is_quarter_window(side), sunk)));
  append(panes, plate(body.cabin_top, is_windscreen(body.cabin_top), sunk));
  append(panes, plate(body.cabin_top, is_rear_window(body.cabin_top), sunk));
  return {{m.glass, panes, 60.0}};
}

std::vector<Part> underbody_and_grille(const Body& body, const CarMaterials& m) {
  Shape black = moved(rounded_box({3.6, 0.06, 1.1}, 0.02, 2), {0.0, 0.185, 0.0});
  append(black, moved(rounded_box({1.0, 0.44, 0.96}, 0.04, 2), {1.5, 0.44, 0.0}));
  append(black, moved(rounded_box({0.75, 0.5, 0.96}, 0.04, 2), {-1.65, 0.46, 0.0}));
  append(black, moved(rounded_box({1.86, 0.07, 1.6}, 0.02, 2), {0.02, 0.195, 0.0}));
  for (const double axle : {front_axle, rear_axle}) {
    append(black, on_both_sides(wheel_house(axle)));
    append(black,
           moved(turned(cylinder(0.03, 1.3, 20), 90.0, {1, 0, 0}), {axle, wheel_radius, -0.65}));
  }
  for (const Cells& cells : {is_grille(body.nose), is_air_intake(body.nose)}) {
    append(black, pit(body.nose, cells, 0.075));
  }
  append(black, pit(body.tail, is_plate_recess(body.tail), 0.035));
  append(black, pit(body.tail, is_diffuser(body.tail), 0.12));
  append(black, bars(body.tail, is_diffuser(body.tail), 0, 20, 0.03, 0.012));
  append(black, plate(body.cowl, 0.01));
  Shape gloss = bars(body.nose, is_air_intake(body.nose), 3, 5, 0.035, 0.003);
  append(gloss, bars(body.nose, is_grille(body.nose), 4, 0, 0.012, 0.0055));
  append(gloss, bars(body.nose, is_grille(body.nose), 0, 4, 0.016, 0.003));
  return {{m.black_plastic, black, 45.0}, {m.gloss_black, gloss, 60.0}};
}

std::vector<Part> trim(const Body& body, const CarMaterials& m) {
  const Sheet& side = body.cabin_side;
  Shape seals = on_both_sides(plate(side, is_middle_pillar(side), 0.002));
  for (const Cells& window : {is_door_window(side), is_quarter_window(side)}) {
    append(seals, on_both_sides(beads_along_edges(plate(side, window), 0.0055)));
  }
  for (const Cells& window : {is_windscreen(body.cabin_top), is_rear_window(body.cabin_top)}) {
    append(seals, beads_along_edges(plate(body.cabin_top, window), 0.006));
  }
  append(seals, wiper(-0.08, 0.6));
  append(seals, wiper(-0.66, -0.12));
  Shape bright = beads_along_edges(plate(body.nose, is_grille(body.nose)), 0.006);
  Shape pipes;
  for (const double z : {-0.52, 0.52}) {
    append(pipes, moved(tail_pipe(), {-2.1, 0.25, z}));
  }
  append(bright, pipes);
  const DVec3 badge_place = on_skin({2.17, 0.65, 0.0});
  const DVec3 up = skin_normal(badge_place);
  const Shape badge = turned(
      lathe({{0.036, -0.004}, {0.036, 0.002}, {0.033, 0.005}, {0.03, 0.002}, {0.0, 0.003}}, 48),
      90.0, {1, 0, 0});
  append(bright, transformed(badge, facing(badge_place, up)));
  return {{m.gloss_black, seals, 60.0},
          {m.chrome, bright, 45.0},
          {m.paint, on_both_sides(door_handle()), 50.0}};
}

std::vector<Part> mirrors(const CarMaterials& m) {
  const Shape block = rounded_box({0.12, 0.125, 0.2}, 0.045, 6, 6);
  const Shape housing = moved(deformed(block,
                                       [](const DVec3& p) {
                                         const double ahead = p.x / 0.06;
                                         const double shrink = 1.0 - 0.22 * ahead;
                                         return DVec3(p.x - 0.2 * p.z * p.z / 0.1,
                                                      p.y * shrink + 0.08 * p.z, p.z * shrink);
                                       }),
                              {0.62, 0.985, 0.93});
  Shape stalks = tube({{0.63, 0.88, 0.76}, {0.63, 0.92, 0.83}, {0.62, 0.955, 0.89}}, 0.016, 14);
  const Shape mirror_glass =
      moved(turned(rounded_box({0.006, 0.105, 0.175}, 0.003, 2), 6.0), {0.556, 0.987, 0.925});
  return {{m.paint, on_both_sides(housing), 50.0},
          {m.gloss_black, on_both_sides(stalks), 50.0},
          {m.mirror, on_both_sides(mirror_glass), 40.0}};
}

std::vector<Part> front_number_plate(const CarMaterials& m) {
  return posed(number_plate(m), facing({2.218, 0.425, 0.0}, {1.0, 0.05, 0.0}));
}

std::vector<Part> rear_number_plate(const CarMaterials& m) {
  const DVec3 middle = seen_from_around(-1.0, 180.0, 0.61);
  return posed(number_plate(m), facing(middle + DVec3(0.008, 0.0, 0.0), {-1.0, -0.08, 0.0}));
}

}  // namespace foveola::scenes::car
