#include <array>
#include <cmath>
#include <numbers>

#include "scenes/modelling/props.h"
#include "scenes/studio_car/body_surface.h"
#include "scenes/studio_car/parts.h"

namespace foveola::scenes {
namespace {

using std::numbers::pi;
constexpr double groove_depth = 0.007;

struct TreadRow {
  double radius;
  double across;        ///< from the tyre's middle
  bool is_cut = false;  ///< by the grooves between blocks
};

/// The tyre's outline from one bead over the tread to the other.
std::vector<TreadRow> tyre_rows() {
  constexpr double w = car::tyre_half_width;
  const std::vector<DVec2> side = {{0.212, 0.012},  {0.215, 0.001},  {0.232, 0.001},
                                   {0.236, -0.003}, {0.262, -0.005}, {0.266, -0.008},
                                   {0.27, -0.005},  {0.3, 0.004},    {0.315, 0.014}};
  std::vector<TreadRow> rows;
  for (const DVec2& point : side) {
    rows.push_back({point.x, point.y - w});
  }
  rows.push_back({0.322, 0.02 - w, true});
  rows.push_back({0.327, 0.03 - w, true});
  constexpr double half_groove = 0.0045;
  for (const double groove : {-0.05, -0.017, 0.017, 0.05}) {
    const bool is_outer_block = groove < -0.02;
    rows.push_back({0.33, groove - half_groove, is_outer_block});
    rows.push_back({0.33 - groove_depth, groove - 0.7 * half_groove});
    rows.push_back({0.33 - groove_depth, groove + 0.7 * half_groove});
    rows.push_back({0.33, groove + half_groove, groove > 0.02});
  }
  rows.push_back({0.327, w - 0.03, true});
  rows.push_back({0.322, w - 0.02, true});
  for (auto point = side.rbegin(); point != side.rend(); ++point) {
    rows.push_back({point->x, w - point->y});
  }
  return rows;
}

/// A spoke from the hub to the rim, along +Z, its face towards +Y.
Shape spoke() {
  constexpr double from = 0.04;
  constexpr double to = 0.218;
  const Shape bar = rounded_box({0.026, 0.028, to - from}, 0.009, 2, 3);
  return deformed(bar, [](const DVec3& p) {
    const double t = p.z / (to - from) + 0.5;
    const double width = 1.15 - 0.75 * t + 0.65 * t * t * t;
    const double height = 0.045 + 0.05 * std::sin(0.5 * std::numbers::pi * t);
    return DVec3(p.x * width, p.y * (1.2 - 0.45 * t) + height, std::lerp(from, to, t));
  });
}

Shape rim() {
  Shape shape =
      lathe({{0.215, -0.1},   {0.228, -0.098}, {0.228, -0.09}, {0.205, -0.085}, {0.2, -0.06},
             {0.19, 0.02},    {0.2, 0.06},     {0.207, 0.084}, {0.213, 0.088},  {0.224, 0.09},
             {0.2285, 0.094}, {0.2295, 0.099}, {0.227, 0.103}, {0.222, 0.103},  {0.213, 0.098},
             {0.207, 0.09},   {0.196, 0.07},   {0.186, 0.02},  {0.192, -0.06},  {0.2, -0.097},
             {0.215, -0.1}},
            88);
  for (int i = 0; i < 5; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const Shape leaning = moved(turned(spoke(), 7.0 * side), {0.015 * side, 0.0, 0.0});
      append(shape, turned(leaning, 72.0 * i));
    }
  }
  append(shape, lathe({{0.0, 0.0},
                       {0.06, 0.0},
                       {0.066, 0.02},
                       {0.066, 0.048},
                       {0.06, 0.06},
                       {0.035, 0.064},
                       {0.033, 0.058},
                       {0.0, 0.058}},
                      64));
  return shape;
}

Shape bolts() {
  Shape shape;
  for (int i = 0; i < 5; ++i) {
    const Shape bolt =
        lathe({{0.0, 0.0}, {0.009, 0.0}, {0.009, 0.014}, {0.007, 0.017}, {0.0, 0.017}}, 6);
    append(shape, turned(moved(bolt, {0.0, 0.056, 0.05}), 72.0 * i + 36.0));
  }
  append(shape, moved(ellipsoid({0.03, 0.008, 0.03}, 32), {0.0, 0.06, 0.0}));
  return shape;
}

Shape brake_disc() {
  return lathe({{0.08, -0.034},
                {0.165, -0.034},
                {0.167, -0.032},
                {0.167, -0.024},
                {0.165, -0.022},
                {0.165, -0.014},
                {0.167, -0.012},
                {0.167, -0.004},
                {0.165, -0.002},
                {0.085, -0.002},
                {0.08, 0.018},
                {0.05, 0.02},
                {0.0, 0.02}},
               72);
}

/// A block around the disc's edge, at the rear of the wheel.
Shape caliper() {
  const Shape block = rounded_box({0.2, 0.075, 0.07}, 0.018, 2, 6);
  return deformed(block, [](const DVec3& p) {
    const double angle = p.x / 0.15;
    const double radius = 0.15 + p.z;
    return DVec3(radius * std::sin(angle), p.y - 0.012, radius * std::cos(angle));
  });
}

}  // namespace

Shape tyre() {
  const std::vector<TreadRow> rows = tyre_rows();
  constexpr int pitches = 46;
  // A block from the first station to the second, then a groove that is deepest at the third.
  constexpr std::array<double, 3> stations = {0.0, 0.74, 0.82};
  constexpr int columns = pitches * static_cast<int>(stations.size());
  const int row_cells = static_cast<int>(rows.size()) - 1;
  Shape shape = patch(columns, row_cells, [&](double u, double v) {
    const auto column = static_cast<std::size_t>(std::lround(u * columns));
    const TreadRow& row = rows[static_cast<std::size_t>(std::lround(v * row_cells))];
    const std::size_t station = column % stations.size();
    const double pitch = static_cast<double>(column / stations.size()) + stations[station];
    const double skew = 9.0 * std::abs(row.across);
    const double angle = 2.0 * pi * (pitch + skew) / pitches;
    const double radius = row.radius - (row.is_cut && station == 2 ? groove_depth : 0.0);
    return DVec3(radius * std::sin(angle), row.across + car::tyre_half_width,
                 radius * std::cos(angle));
  });
  return shape;
}

namespace car {

std::vector<Part> wheel(const CarMaterials& m) {
  return {{m.rubber, moved(tyre(), {0.0, -tyre_half_width, 0.0}), 35.0},
          {m.alloy, rim(), 45.0},
          {m.chrome, bolts(), 35.0},
          {m.iron, brake_disc(), 35.0},
          {m.caliper, turned(caliper(), -70.0), 50.0}};
}

}  // namespace car
}  // namespace foveola::scenes
