#include "scenes/modelling/architecture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"

namespace foveola::scenes {
namespace {

using std::numbers::pi;

/// How far the pointed arch's two circles have their middles from the arch's own, in half spans.
constexpr double arch_offset = 0.35;

/// The length of the pointed arch from its crown to s, in half spans; near enough for uvs where
/// height and span differ.
double pointed_arch_length(double s) {
  const double radius = 1.0 + arch_offset;
  const double to_crown = std::asin(arch_offset / radius);
  const double length = radius * (std::asin((std::abs(s) + arch_offset) / radius) - to_crown);
  return std::copysign(length, s);
}

}  // namespace

Shape swept(const std::vector<DVec3>& path, const std::vector<DVec2>& profile, const DVec3& side) {
  const auto last = static_cast<int>(path.size()) - 1;
  const auto corners = static_cast<int>(profile.size());
  double along = 0.0;
  std::vector<double> lengths = {0.0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    along += glm::distance(path[i], path[i - 1]);
    lengths.push_back(along);
  }
  double around = 0.0;
  std::vector<double> perimeter = {0.0};
  for (int i = 1; i <= corners; ++i) {
    around += glm::distance(profile[static_cast<std::size_t>(i % corners)],
                            profile[static_cast<std::size_t>(i - 1)]);
    perimeter.push_back(around);
  }
  Shape shape = patch(corners, last, [&](double u, double v) {
    const int i = static_cast<int>(std::lround(v * last));
    const auto corner = static_cast<std::size_t>(std::lround(u * corners) % corners);
    const DVec3& before = path[static_cast<std::size_t>(std::max(i - 1, 0))];
    const DVec3& after = path[static_cast<std::size_t>(std::min(i + 1, last))];
    const DVec3 up = glm::cross(side, glm::normalize(after - before));
    return path[static_cast<std::size_t>(i)] + profile[corner].x * side + profile[corner].y * up;
  });
  for (DVec2& uv : shape.uvs) {
    uv = {perimeter[static_cast<std::size_t>(std::lround(uv.x * corners))],
          lengths[static_cast<std::size_t>(std::lround(uv.y * last))]};
  }
  return inside_out(shape);
}

std::vector<DVec2> rib_profile(double width, double height) {
  const double w = 0.5 * width;
  const double h = 0.5 * height;
  return {{w, h}, {-w, h}, {-w, -0.2 * h}, {-0.35 * w, -h}, {0.35 * w, -h}, {w, -0.2 * h}};
}

std::vector<DVec3> round_arch_path(double radius, double stilt, int segments) {
  std::vector<DVec3> path;
  if (stilt > 0.0) {
    path.emplace_back(-radius, -stilt, 0.0);
  }
  for (int i = 0; i <= segments; ++i) {
    const double angle = pi * (1.0 - static_cast<double>(i) / segments);
    path.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  if (stilt > 0.0) {
    path.emplace_back(radius, -stilt, 0.0);
  }
  return path;
}

double pointed_arch(double s) {
  const double radius = 1.0 + arch_offset;
  const double across = std::min(std::abs(s), 1.0) + arch_offset;
  return std::sqrt(std::max(0.0, radius * radius - across * across) / (1.0 + 2.0 * arch_offset));
}

DVec3 on_vault(const VaultBay& bay, double s, double t) {
  return bay.middle + DVec3(s * bay.half_x,
                            bay.rise * pointed_arch(std::min(std::abs(s), std::abs(t))),
                            t * bay.half_z);
}

Shape vault_webs(const VaultBay& bay, int columns, int rows) {
  Shape webs;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const DVec2 out(std::lround(std::cos(0.5 * pi * quarter)),
                    std::lround(std::sin(0.5 * pi * quarter)));
    const DVec2 across(-out.y, out.x);
    const DVec2 half(bay.half_x, bay.half_z);
    // Steep near the groins, where k nears 1 at the outer edge, hence closer lines there.
    const auto position = [&](double u, double r) {
      const double k = std::sin(0.5 * pi * (2.0 * u - 1.0));
      return DVec2(k * r, r);
    };
    Shape web = patch(columns, rows, [&](double u, double r) {
      const DVec2 p = position(u, r);
      const DVec2 st = p.x * across + p.y * out;
      return on_vault(bay, st.x, st.y);
    });
    for (DVec2& uv : web.uvs) {
      const DVec2 p = position(uv.x, uv.y);
      uv = {p.y * glm::length(half * out),
            pointed_arch_length(p.x) * 0.5 * (glm::length(half * across) + bay.rise)};
    }
    append(webs, inside_out(web));
  }
  return webs;
}

std::vector<DVec3> vault_line(const VaultBay& bay, const DVec2& from, const DVec2& to,
                              int segments) {
  std::vector<DVec3> path;
  for (int i = 0; i <= segments; ++i) {
    const double t = 0.5 + 0.5 * std::sin(pi * (static_cast<double>(i) / segments - 0.5));
    const DVec2 p = from + (to - from) * t;
    path.push_back(on_vault(bay, p.x, p.y));
  }
  return path;
}

Shape shaft(double radius, double height, int segments) {
  const double r = radius;
  return lathe({{0.0, 0.0},
                {1.7 * r, 0.0},
                {1.7 * r, 0.5 * r},
                {r, 1.2 * r},
                {r, height - 3.2 * r},
                {1.3 * r, height - 3.0 * r},
                {1.05 * r, height - 2.6 * r},
                {1.9 * r, height - 0.5 * r},
                {1.9 * r, height},
                {0.0, height}},
               segments);
}

Shape robed_figure(double height) {
  const Shape robe = lathe({{0.0, 0.0},
                            {0.235, 0.0},
                            {0.225, 0.05},
                            {0.19, 0.25},
                            {0.165, 0.45},
                            {0.15, 0.6},
                            {0.165, 0.72},
                            {0.175, 0.78},
                            {0.13, 0.83},
                            {0.06, 0.855},
                            {0.05, 0.88}},
                           24);
  Shape figure = deformed(robe, [](const DVec3& p) {
    const double angle = std::atan2(p.x, p.z);
    const double looseness = std::clamp(1.0 - p.y / 0.75, 0.0, 1.0);
    const double fold = 1.0 + 0.1 * looseness * std::sin(8.0 * angle + 2.5 * p.y);
    return DVec3(p.x * fold, p.y, p.z * fold * 0.82);
  });
  append(figure, moved(ellipsoid({0.062, 0.085, 0.072}, 12), {0.0, 0.925, 0.01}));
  append(figure, moved(ellipsoid({0.075, 0.09, 0.078}, 12), {0.0, 0.94, -0.012}));
  append(figure, moved(ellipsoid({0.014, 0.02, 0.02}, 8), {0.0, 0.92, 0.08}));
  for (const double side : {-1.0, 1.0}) {
    append(figure, tube({{side * 0.14, 0.79, 0.0},
                         {side * 0.2, 0.68, 0.03},
                         {side * 0.19, 0.59, 0.09},
                         {side * 0.05, 0.62, 0.17}},
                        0.052, 8));
    append(figure, moved(ellipsoid({0.03, 0.045, 0.022}, 8), {side * 0.022, 0.66, 0.19}));
  }
  // The cloak falls over both shoulders and hangs open in front; out along its outside and back
  // along its inside.
  append(figure, patch(32, 7, [](double u, double v) {
           const double angle = pi * (0.28 + 0.72 * (1.0 - std::cos(2.0 * pi * u)));
           const double thickness = 0.06 * std::min(1.0, 8.0 * v * (1.0 - v));
           const double fold =
               1.0 + 0.05 * (1.0 - v) * std::sin(9.0 * angle) + thickness * std::sin(2.0 * pi * u);
           const double taper = v > 0.85 ? 1.0 - 2.6 * (v - 0.85) : 1.0;
           const double r = std::lerp(0.27, 0.185, std::min(1.0, 1.3 * v)) * fold * taper;
           return DVec3(r * std::sin(angle), 0.08 + 0.76 * v, 0.85 * r * std::cos(angle));
         }));
  return scaled(figure, DVec3(height));
}

Shape wall_with_round_hole(double width, double height, double radius, double depth) {
  constexpr int segments = 64;  // a multiple of 8, so that the corners are met
  const DVec2 half(0.5 * width, 0.5 * height);
  const auto direction = [](double u) {
    return DVec2(std::cos(2.0 * pi * u), std::sin(2.0 * pi * u));
  };
  Shape face = patch(segments, 4, [&](double u, double v) {
    const DVec2 d = direction(u);
    const DVec2 on_square = d / std::max(std::abs(d.x), std::abs(d.y)) * half;
    return DVec3(glm::mix(on_square, radius * d, v), 0.0);
  });
  face = with_projected_uvs(face, {1, 0, 0}, {0, -1, 0});
  Shape side = patch(segments, 1,
                     [&](double u, double v) { return DVec3(radius * direction(u), -depth * v); });
  for (DVec2& uv : side.uvs) {
    uv = {2.0 * pi * radius * uv.x, depth * uv.y};
  }
  append(face, side);
  return face;
}

}  // namespace foveola::scenes
