// The chairs: swivel chairs around the table, chairs on four legs along the walls.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "scenes/meeting_room/parts.h"

namespace foveola::scenes::meeting {
namespace {

using std::numbers::pi;

/// A chair that stands on the origin and faces +Z.
struct Chair {
  Shape cushions;
  Shape piping;
  Shape metal;
  Shape plastic;
};

/// A closed line around a rounded rectangle about the origin.
std::vector<DVec2> rounded_outline(double half_width, double half_height, double radius) {
  constexpr int steps = 4;
  std::vector<DVec2> outline;
  for (int corner = 0; corner < 4; ++corner) {
    const double first = 0.5 * pi * corner;
    const DVec2 middle((corner == 0 || corner == 3 ? 1.0 : -1.0) * (half_width - radius),
                       (corner < 2 ? 1.0 : -1.0) * (half_height - radius));
    for (int i = 0; i <= steps; ++i) {
      const double angle = first + 0.5 * pi * i / steps;
      outline.push_back(middle + radius * DVec2(std::cos(angle), std::sin(angle)));
    }
  }
  outline.push_back(outline.front());
  return outline;
}

/// Points between an outline's, so that it can follow a bent cushion.
std::vector<DVec3> refined(const std::vector<DVec2>& outline, double step) {
  std::vector<DVec3> path;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const int pieces =
        std::max(1, static_cast<int>(glm::distance(outline[i], outline[i + 1]) / step));
    for (int k = 0; k < pieces; ++k) {
      path.emplace_back(glm::mix(outline[i], outline[i + 1], static_cast<double>(k) / pieces), 0.0);
    }
  }
  path.push_back(path.front());
  return path;
}

/// How the back is curved: hollow for shoulders, bulging at the loins.
DVec3 bent_back(const DVec3& p) {
  const double loins = 0.025 * std::cos(pi * (p.y + 0.08) / 0.3);
  return {p.x, p.y, p.z + 1.0 * p.x * p.x + loins};
}

DVec3 dished_seat(const DVec3& p) {
  const double dish = p.y > 0.0 ? -0.014 * std::cos(2.6 * p.x) * std::cos(4.0 * (p.z + 0.04)) : 0.0;
  const double front = std::max(0.0, p.z - 0.1);
  return {p.x, p.y + dish - 1.2 * front * front, p.z};
}

/// Cushions with two stitched seams across the back and piping around both.
void add_cushions(Chair& chair) {
  const Shape seat = deformed(rounded_box({0.48, 0.085, 0.47}, 0.036, 3, 5), dished_seat);
  append(chair.cushions, moved(seat, {0.0, seat_height, 0.0}));
  const Shape back = deformed(rounded_box({0.45, 0.46, 0.066}, 0.03, 3, 9), [](const DVec3& p) {
    const double seams = std::exp(-std::pow((std::abs(p.y) - 0.085) / 0.014, 2.0));
    return bent_back({p.x, p.y, p.z * (1.0 - 0.3 * seams)});
  });
  const auto lean = [](const Shape& shape) {
    return moved(turned(shape, -10.0, {1, 0, 0}), {0.0, seat_height + 0.35, -0.27});
  };
  append(chair.cushions, lean(back));
  const Shape back_piping =
      deformed(tube(refined(rounded_outline(0.226, 0.231, 0.036), 0.06), 0.0055, 5), bent_back);
  append(chair.piping, lean(back_piping));
  const Shape flat = tube(refined(rounded_outline(0.241, 0.236, 0.04), 0.06), 0.0055, 5);
  append(chair.piping,
         moved(deformed(turned(flat, 90.0, {1, 0, 0}), dished_seat), {0.0, seat_height, 0.0}));
}

/// A twin wheel that stands on the origin and rolls along Z.
Shape castor() {
  const Shape wheel = moved(turned(lathe({{0.0, 0.0},
                                          {0.02, 0.0},
                                          {0.027, 0.004},
                                          {0.027, 0.014},
                                          {0.02, 0.018},
                                          {0.0, 0.018}},
                                         12),
                                   -90.0, {0, 0, 1}),
                            {0.0, 0.027, 0.0});
  Shape shape = moved(wheel, {0.004, 0.0, 0.0});
  append(shape, moved(wheel, {-0.022, 0.0, 0.0}));
  append(shape, moved(rounded_box({0.03, 0.03, 0.035}, 0.01, 1), {0.0, 0.05, -0.006}));
  append(shape, moved(cylinder(0.006, 0.03, 8), {0.0, 0.055, -0.012}));
  return shape;
}

Chair make_swivel_chair() {
  Chair chair;
  add_cushions(chair);
  for (int i = 0; i < 5; ++i) {
    const double turn_deg = 72.0 * i + 20.0;
    const Shape leg = tube(
        {{0.0, 0.13, 0.0}, {0.0, 0.12, 0.08}, {0.0, 0.09, 0.29}, {0.0, 0.085, 0.31}}, 0.017, 8);
    append(chair.metal, turned(leg, turn_deg));
    append(chair.plastic, turned(moved(turned(castor(), 35.0 * i), {0.0, 0.0, 0.3}), turn_deg));
  }
  append(chair.metal, moved(lathe({{0.0, 0.0},
                                   {0.036, 0.0},
                                   {0.04, 0.02},
                                   {0.036, 0.06},
                                   {0.028, 0.07},
                                   {0.028, 0.18},
                                   {0.018, 0.182},
                                   {0.018, 0.33}},
                                  16),
                            {0.0, 0.09, 0.0}));
  append(chair.plastic,
         moved(rounded_box({0.2, 0.04, 0.26}, 0.014, 1), {0.0, seat_height - 0.055, -0.01}));
  // A flat bar carries the back, and two loops the arms.
  append(chair.metal, scaled(tube({{0.0, seat_height - 0.06, -0.1},
                                   {0.0, seat_height - 0.06, -0.24},
                                   {0.0, seat_height - 0.03, -0.285},
                                   {0.0, seat_height + 0.1, -0.3},
                                   {0.0, seat_height + 0.3, -0.31}},
                                  0.014, 8),
                             {2.2, 1.0, 1.0}));
  for (const double side : {-1.0, 1.0}) {
    const double x = side * 0.27;
    append(chair.metal, tube({{side * 0.1, seat_height - 0.06, 0.0},
                              {side * 0.25, seat_height - 0.06, 0.0},
                              {x, seat_height - 0.045, 0.0},
                              {x + side * 0.01, seat_height + 0.08, 0.01},
                              {x, seat_height + 0.18, 0.02}},
                             0.012, 8));
    append(chair.plastic,
           moved(rounded_box({0.06, 0.026, 0.27}, 0.012, 2), {x, seat_height + 0.19, 0.03}));
  }
  append(chair.plastic,
         tube({{0.1, seat_height - 0.055, 0.05}, {0.26, seat_height - 0.06, 0.06}}, 0.006, 6));
  return chair;
}

Chair make_visitors_chair() {
  Chair chair;
  chair.cushions = moved(rounded_box({0.47, 0.08, 0.46}, 0.035, 3), {0.0, seat_height, 0.0});
  const Shape back = deformed(rounded_box({0.45, 0.44, 0.06}, 0.028, 3, 5), [](const DVec3& p) {
    return DVec3(p.x, p.y, p.z + 1.0 * p.x * p.x);
  });
  append(chair.cushions, moved(turned(back, -10.0, {1, 0, 0}), {0.0, seat_height + 0.33, -0.26}));
  for (const double side : {-1.0, 1.0}) {
    const double x = side * 0.25;
    // One bent tube is front leg, arm and back leg.
    append(chair.metal, tube({{x, 0.005, 0.24},
                              {x, 0.3, 0.23},
                              {x, seat_height + 0.16, 0.215},
                              {x, seat_height + 0.195, 0.19},
                              {x, seat_height + 0.2, 0.15},
                              {x, seat_height + 0.2, -0.15},
                              {x, seat_height + 0.185, -0.2},
                              {x, seat_height + 0.14, -0.225},
                              {x, 0.3, -0.25},
                              {x, 0.005, -0.29}},
                             0.012, 8));
    append(chair.metal,
           tube({{x, seat_height - 0.02, 0.22}, {x, seat_height - 0.02, -0.24}}, 0.01, 8));
    append(chair.plastic,
           moved(rounded_box({0.045, 0.024, 0.28}, 0.011, 2), {x, seat_height + 0.212, 0.0}));
    append(chair.plastic, moved(cylinder(0.016, 0.012, 10), {x, 0.0, 0.24}));
    append(chair.plastic, moved(cylinder(0.016, 0.012, 10), {x, 0.0, -0.29}));
  }
  for (const double z : {0.14, -0.16}) {
    append(chair.metal,
           tube({{-0.25, seat_height - 0.03, z}, {0.25, seat_height - 0.03, z}}, 0.01, 8));
  }
  return chair;
}

std::vector<Part> placed(const Chair& chair, const Materials& m, int fabric, const DVec3& place,
                         double turn_deg) {
  const auto put = [&](const Shape& shape) { return moved(turned(shape, turn_deg), place); };
  std::vector<Part> parts = {{fabric, with_uv_scale(put(chair.cushions), 4.0), 50.0},
                             {m.chrome, put(chair.metal), 50.0},
                             {m.black_plastic, put(chair.plastic), 50.0}};
  if (!chair.piping.triangles.empty()) {
    parts.push_back({m.dark_piping, put(chair.piping), 60.0});
  }
  return parts;
}

}  // namespace

void add_chairs(Model& model, const Materials& m) {
  const Chair swivel = make_swivel_chair();
  const Chair visitors = make_visitors_chair();
  int number = 1;
  const auto add = [&](const Chair& chair, double x, double z, double turn_deg) {
    add_object(model, fmt::format("Chair {}", number++),
               placed(chair, m, m.fabric, {x, 0.0, z}, turn_deg));
  };
  for (int i = 0; i < seats_along_table; ++i) {
    // Nobody leaves chairs in a straight line.
    const double askew_deg = 14.0 * std::sin(2.3 * i + 0.4);
    add(swivel, seat_x(i), -1.22 - 0.05 * std::sin(1.7 * i), askew_deg);
    add(swivel, seat_x(i), 1.22 + 0.06 * std::sin(2.9 * i), 180.0 - askew_deg);
  }
  add(swivel, table_half_length + 0.35, 0.05, -95.0);
  add(swivel, -table_half_length - 0.35, -0.1, 80.0);
  for (int i = 0; i < 6; ++i) {
    add(visitors, 0.2 + 0.85 * i, -half_z + 0.42, 0.0);
  }
  for (int i = 0; i < 4; ++i) {
    add(visitors, 2.0 + 0.75 * i, half_z - 0.55, 180.0);
  }
  add_object(model, "Red chair", placed(swivel, m, m.red_fabric, {-0.3, 0.0, 2.75}, -130.0));
}

}  // namespace foveola::scenes::meeting
