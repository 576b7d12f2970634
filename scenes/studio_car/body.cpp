#include "scenes/studio_car/body.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "renderer/base/angles.h"
#include "scenes/modelling/painting.h"
#include "scenes/studio_car/body_surface.h"

namespace foveola::scenes::car {
namespace {

using paint::smooth_step;

constexpr double half_gap = 0.0022;
constexpr double sill_top = 0.232;
constexpr double nose_axis_x = 1.0;
constexpr double tail_axis_x = -1.0;
constexpr double end_angle_deg = 46.0;  ///< how far bumpers wrap around, from the middle
constexpr double scuttle_x = 0.93;
constexpr double scuttle_half_width = 0.71;
constexpr double belt_from_x = 0.7;
constexpr double door_front = 0.69;
constexpr double door_rear = -0.6;

constexpr int cabin_columns = 110;
constexpr int cabin_rows = 18;
constexpr int top_rows = 52;
constexpr int end_columns = 160;
constexpr int end_rows = 40;

double nose_top(double angle_deg) {
  const double share = angle_deg / end_angle_deg;
  return 0.622 + 0.078 * share * share;
}

double tail_top(double angle_deg) {
  const double share = angle_deg / end_angle_deg;
  return 0.945 - 0.045 * share * share;
}

/// `angle_deg` from the middle of the nose towards +Z.
DVec3 on_nose(double angle_deg, double y) { return seen_from_around(nose_axis_x, angle_deg, y); }

/// `angle_deg` from the middle of the tail towards +Z.
DVec3 on_tail(double angle_deg, double y) {
  return seen_from_around(tail_axis_x, 180.0 - angle_deg, y);
}

std::vector<DVec3> line(const std::vector<double>& stations, const Curve& curve) {
  std::vector<DVec3> points;
  for (const double station : stations) {
    points.push_back(curve(station));
  }
  return points;
}

/// A height that is given at some shares v of a bumper's rows and runs straight between them.
double height_at(const std::vector<DVec2>& knots, double v) {
  std::size_t i = 0;
  while (i + 2 < knots.size() && v > knots[i + 1].x) {
    ++i;
  }
  return std::lerp(knots[i].y, knots[i + 1].y, (v - knots[i].x) / (knots[i + 1].x - knots[i].x));
}

/// The rows bend so that they follow the lower edges of grille and lamps, and their upper edges.
Sheet make_nose() {
  return sheet(even(-1.0, 1.0, end_columns), even(0.0, 1.0, end_rows), [](double u, double v) {
    const double out = std::abs(u);
    const double to_lamp = smooth_step(0.3, 0.5, out);
    const std::vector<DVec2> knots = {{0.0, 0.165 + 0.03 * u * u},
                                      {0.15, 0.225},
                                      {0.45, 0.375 - 0.02 * out},
                                      {0.6, std::lerp(0.455, 0.535 + 0.03 * (out - 0.5), to_lamp)},
                                      {0.9, std::lerp(0.59, 0.615 + 0.075 * (out - 0.5), to_lamp)},
                                      {1.0, nose_top(end_angle_deg * u)}};
    return on_nose(end_angle_deg * u, height_at(knots, v));
  });
}

Sheet make_tail() {
  return sheet(even(1.0, -1.0, end_columns), even(0.0, 1.0, end_rows), [](double u, double v) {
    const double out = std::abs(u);
    const std::vector<DVec2> knots = {{0.0, 0.185}, {0.2, 0.31},
                                      {0.45, 0.52}, {0.7, 0.7 + 0.04 * smooth_step(0.2, 0.5, out)},
                                      {0.9, 0.82},  {1.0, tail_top(end_angle_deg * u)}};
    return on_tail(end_angle_deg * u, height_at(knots, v));
  });
}

/// Under the windscreen, around its foot.
DVec3 on_scuttle(double z) { return seen_from_above(1.05 - 0.22 * z * z, z); }

/// From the bumper's corner backwards along the bonnet and then along the foot of the windscreen's
/// pillar to where the door begins.
DVec3 on_bonnet_edge(double x, double inwards) {
  const DVec3 corner = on_nose(end_angle_deg, nose_top(end_angle_deg));
  const DVec3 belt = seen_from_side(belt_from_x, 0.905);
  const double z =
      x > scuttle_x
          ? std::lerp(scuttle_half_width, corner.z, (x - scuttle_x) / (corner.x - scuttle_x))
          : std::lerp(belt.z, scuttle_half_width, (x - belt_from_x) / (scuttle_x - belt_from_x));
  return seen_from_above(x, z - inwards);
}

Sheet make_bonnet() {
  const std::vector<double> us = even(-1.0, 1.0, top_rows);
  const std::vector<double> vs = even(0.0, 1.0, 52);
  const auto front = line(us, [](double u) {
    const double angle = u * (end_angle_deg - 0.25);
    return on_nose(angle, nose_top(angle) + 2.0 * half_gap);
  });
  const double from = front.back().x;
  const auto left = line(vs, [&](double v) {
    return v == 0.0 ? front.back() : on_bonnet_edge(std::lerp(from, scuttle_x, v), 2.0 * half_gap);
  });
  const auto back = line(us, [&](double u) {
    return std::abs(u) == 1.0 ? left.back() * DVec3(1.0, 1.0, u)
                              : on_scuttle(u * scuttle_half_width);
  });
  std::vector<DVec3> right = left;
  for (DVec3& point : right) {
    point.z = -point.z;
  }
  return sheet_between(front, back, right, left);
}

constexpr double bumper_foot = 0.2;  ///< foot of the strip between wheel and bumper

/// The side's lower edge: the arch within the wheel's reach, the sill between the wheels, the
/// bumpers' lower edge beyond them.
double lower_edge(double axle, double x) {
  const double from_axle = std::abs(x - axle);
  if (from_axle >= wheel_arch_radius) {
    return std::abs(x) > std::abs(axle) ? bumper_foot : sill_top;
  }
  const double rise = std::sqrt(wheel_arch_radius * wheel_arch_radius - from_axle * from_axle);
  return wheel_radius + rise;
}

/// Stations from `from` backwards to `to`, dense where the arch is steep.
std::vector<double> arch_stations(double axle, double from, double to) {
  std::vector<double> xs = even(from, to, 28);
  for (const double angle : even(0.0, radians(180.0), 44)) {
    xs.push_back(axle + 0.9999 * wheel_arch_radius * std::cos(angle));
  }
  xs.push_back(axle + 1.004 * wheel_arch_radius);
  xs.push_back(axle - 1.004 * wheel_arch_radius);
  std::erase_if(xs, [&](double x) { return x > from || x < to; });
  return falling(xs, 2e-4);
}

double belt(double x) {
  return 0.905 + 0.025 * smooth_step(0.7, -0.6, x) - 0.03 * smooth_step(-0.9, -1.62, x);
}

DVec3 on_belt(double x) {
  return x > belt_from_x ? on_bonnet_edge(x, 0.0) : seen_from_side(x, belt(x));
}

/// Door shut lines lean backwards as they rise and bend in towards the sill.
double shut_line(double x, double y) {
  const double up = (y - sill_top) / (0.92 - sill_top);
  return x - 0.03 * (up - 1.0) * (up - 1.0) + 0.02 * (1.0 - up);
}

std::vector<DVec3> shut_line_points(double x, int rows) {
  return line(even(sill_top, belt(x), rows),
              [&](double y) { return seen_from_side(shut_line(x, y), y); });
}

Sheet make_fender() {
  constexpr int rows = 30;
  const double rear = door_front + half_gap;
  const auto front = line(even(bumper_foot, nose_top(end_angle_deg), rows),
                          [](double y) { return on_nose(end_angle_deg + 0.25, y); });
  const double foot = shut_line(rear, sill_top);
  const auto bottom_xs = arch_stations(front_axle, front.front().x, foot);
  const auto bottom = line(bottom_xs, [&](double x) {
    return x == bottom_xs.front() ? front.front() : seen_from_side(x, lower_edge(front_axle, x));
  });
  const double top_from = front.back().x;
  const auto top = line(bottom_xs, [&](double x) {
    const double share = (bottom_xs.front() - x) / (bottom_xs.front() - foot);
    return share == 0.0 ? front.back() : on_belt(std::lerp(top_from, rear, share));
  });
  return sheet_between(bottom, top, front, shut_line_points(rear, rows));
}

Sheet make_door() {
  constexpr int rows = 36;
  const auto front = shut_line_points(door_front - half_gap, rows);
  const auto rear = shut_line_points(door_rear + half_gap, rows);
  const auto shares = even(0.0, 1.0, 48);
  const auto bottom = line(shares, [&](double s) {
    return seen_from_side(std::lerp(front.front().x, rear.front().x, s), sill_top);
  });
  const auto top =
      line(shares, [&](double s) { return on_belt(std::lerp(front.back().x, rear.back().x, s)); });
  return sheet_between(bottom, top, front, rear);
}

double belt_end() { return on_tail(end_angle_deg, tail_top(end_angle_deg)).x; }

/// The belt's stations, which the panels below and above it share.
std::vector<double> belt_stations() { return even(scuttle_x, belt_end(), cabin_columns); }

Sheet make_quarter() {
  constexpr int rows = 32;
  const double front = door_rear - half_gap;
  std::vector<double> top_xs = belt_stations();
  std::erase_if(top_xs, [&](double x) { return x > front - 1e-3; });
  top_xs.insert(top_xs.begin(), front);
  const auto left = shut_line_points(front, rows);
  const auto right = line(even(bumper_foot, tail_top(end_angle_deg), rows),
                          [](double y) { return on_tail(end_angle_deg + 0.25, y); });
  const auto bottom = [&] {
    std::vector<double> dense = arch_stations(rear_axle, left.front().x, right.front().x);
    std::vector<double> xs;
    for (std::size_t i = 0; i < top_xs.size(); ++i) {
      const double place = static_cast<double>(i) / static_cast<double>(top_xs.size() - 1) *
                           static_cast<double>(dense.size() - 1);
      const auto below = std::min(static_cast<std::size_t>(place), dense.size() - 2);
      xs.push_back(std::lerp(dense[below], dense[below + 1], place - static_cast<double>(below)));
    }
    return line(xs, [&](double x) { return seen_from_side(x, lower_edge(rear_axle, x)); });
  }();
  const auto top = line(top_xs, on_belt);
  return sheet_between(bottom, top, left, right);
}

Sheet make_sill() {
  const double front = front_axle - wheel_arch_radius + 0.012;
  const double rear = rear_axle + wheel_arch_radius - 0.012;
  return sheet(even(front, rear, 80), even(0.16, sill_top - 2.0 * half_gap, 10),
               [](double x, double y) { return seen_from_side(x, y); });
}

/// The roof's edge from the windscreen's foot to the rear window's.
DVec3 on_roof_edge(double share) {
  const double x = std::lerp(0.905, -1.56, share);
  const double in = 0.1 * smooth_step(0.0, 0.3, share) + 0.05 * smooth_step(0.3, 0.75, share) +
                    0.03 * smooth_step(0.75, 1.0, share);
  return seen_from_above(x, 0.69 - in);
}

std::vector<DVec3> roof_edge() { return line(even(0.0, 1.0, cabin_columns), on_roof_edge); }

Sheet make_cabin_side() {
  const auto bottom = line(belt_stations(), on_belt);
  const auto top = roof_edge();
  const auto between = [&](const DVec3& from, const DVec3& to) {
    return line(even(0.0, 1.0, cabin_rows),
                [&](double v) { return on_skin((1.0 - v) * from + v * to); });
  };
  return sheet_between(bottom, top, between(bottom.front(), top.front()),
                       between(bottom.back(), top.back()));
}

Sheet make_cabin_top() {
  const auto edge = roof_edge();
  Sheet net{edge.size(), top_rows + 1, {}};
  for (const double across : even(1.0, -1.0, top_rows)) {
    for (std::size_t i = 0; i < edge.size(); ++i) {
      const double share = static_cast<double>(i) / cabin_columns;
      const double bow =
          0.24 * (1.0 - smooth_step(0.0, 0.5, share)) - 0.2 * smooth_step(0.5, 1, share);
      const double z = edge[i].z * across;
      const double x = edge[i].x + bow * (edge[i].z * edge[i].z - z * z);
      const bool is_edge = std::abs(across) == 1.0;
      net.points.push_back(is_edge ? edge[i] * DVec3(1, 1, across) : seen_from_above(x, z));
    }
  }
  return net;
}

Sheet make_boot_lid(const Sheet& cabin_top) {
  const std::vector<DVec3> front = cabin_top.column(cabin_top.columns - 1);
  const auto back = line(even(1.0, -1.0, top_rows), [](double u) {
    const double angle = u * (end_angle_deg - 0.25);
    return on_tail(angle, tail_top(angle) + 2.0 * half_gap);
  });
  const auto left = line(even(0.0, 1.0, 36), [&](double v) {
    return on_skin((1.0 - v) * front.front() + v * back.front());
  });
  std::vector<DVec3> right = left;
  for (DVec3& point : right) {
    point.z = -point.z;
  }
  return sheet_between(front, back, left, right);
}

Sheet make_cowl(const Sheet& bonnet, const Sheet& cabin_top) {
  const std::vector<DVec3> front = bonnet.row(bonnet.rows - 1);
  std::vector<DVec3> back = cabin_top.column(0);
  std::reverse(back.begin(), back.end());
  constexpr int rows = 6;
  Sheet net{front.size(), rows + 1, {}};
  for (const double v : even(0.0, 1.0, rows)) {
    for (std::size_t i = 0; i < front.size(); ++i) {
      net.points.push_back(on_skin((1.0 - v) * front[i] + v * back[i]));
    }
  }
  return net;
}

}  // namespace

Body make_body() {
  Body body;
  body.nose = make_nose();
  body.bonnet = make_bonnet();
  body.fender = make_fender();
  body.door = make_door();
  body.quarter = make_quarter();
  body.sill = make_sill();
  body.cabin_side = make_cabin_side();
  body.cabin_top = make_cabin_top();
  body.cowl = make_cowl(body.bonnet, body.cabin_top);
  body.boot_lid = make_boot_lid(body.cabin_top);
  body.tail = make_tail();
  return body;
}

}  // namespace foveola::scenes::car
