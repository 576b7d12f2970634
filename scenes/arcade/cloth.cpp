// Banners on the balustrade and curtains between the columns, on rods and rings.
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/arcade/parts.h"

namespace foveola::scenes::arcade {
namespace {

using std::numbers::pi;
constexpr int columns_per_fold = 10;

struct Drapery {
  double width = 2.0;
  double drop = 2.6;
  int folds = 7;
  double fold_depth = 0.09;
  double hem = 0.07;        ///< height of the doubled cloth at its foot
  double gather = 0.0;      ///< how far a tie draws the cloth together, relative to its width
  double tie_height = 0.4;  ///< height of that tie, as a fraction of the drop from below
};

/// Cloth that hangs from y = 0, its middle at x = 0, facing +Z; uvs over [0, 1]. Its folds start at
/// the rings, one to each, and merge as they fall.
Shape drapery(const Drapery& size, const Seed& seed) {
  Pcg32 random = generator(seed);
  const double phase = 2.0 * pi * random.uniform();
  const double drift = random.uniform() - 0.5;
  Shape shape = patch(columns_per_fold * size.folds, 28, [&](double u, double v) {
    const double fallen = 1.0 - v;
    const double from_tie = v - size.tie_height;
    // Above the tie the cloth narrows slowly; below it falls nearly straight.
    const double near_tie = from_tie > 0.0 ? std::exp(-std::pow(from_tie / 0.24, 2.0))
                                           : 0.8 + 0.2 * std::exp(-std::pow(from_tie / 0.06, 2.0));
    const double narrow = 1.0 - size.gather * near_tie;
    const double depth =
        size.fold_depth * (0.4 + 0.6 * fallen) * (1.0 - 0.5 * size.gather * near_tie);
    const double angle = 2.0 * pi * size.folds * u + phase;
    // Broader folds take over below: every second one fades.
    const double fine = std::sin(angle + 1.2 * drift * fallen);
    const double broad = std::sin(0.5 * angle + 2.0 * drift * fallen + phase);
    const double crease = 0.12 * std::sin(2.0 * angle + 5.0 * fallen);
    const double fold = fine * (1.0 - 0.35 * fallen) + 0.55 * fallen * broad + crease;
    const double sway = 0.25 * std::sin(5.0 * u + 4.0 * fallen + 2.0 * phase);
    const double swing =
        0.12 * size.fold_depth / size.folds * std::cos(angle) * fallen * size.width / size.drop;
    // Between the rings the upper edge sags.
    const double sag = 0.03 * std::exp(-30.0 * fallen) * (1.0 - std::cos(angle - phase)) * 0.5;
    // The hem's second layer, and its seam as a dent above it.
    const double from_seam = size.drop * v - size.hem;
    const double hem = from_seam < 0.0 ? 0.006 : -0.004 * std::exp(-from_seam / 0.015);
    return DVec3((u - 0.5) * size.width * narrow + swing, -size.drop * fallen - sag,
                 depth * (fold + sway) + hem);
  });
  for (DVec2& uv : shape.uvs) {
    uv.y = 1.0 - uv.y;
  }
  return shape;
}

/// Short strings below the cloth's foot.
Shape fringe(const Drapery& size, const Shape& cloth, double length) {
  const int columns = columns_per_fold * size.folds;
  Shape strings;
  for (int i = 0; i < columns; ++i) {
    const DVec3 root = cloth.positions[static_cast<std::size_t>(i)];
    const DVec3 next = cloth.positions[static_cast<std::size_t>(i + 1)];
    for (const double between : {0.25, 0.75}) {
      const DVec3 from = glm::mix(root, next, between) + DVec3(0.0, 0.004, 0.0);
      append(strings, tube({from, from - DVec3(0.002 * std::sin(3.0 * i), length, 0.0)}, 0.005, 4));
    }
  }
  return strings;
}

/// A rod with knobs at its ends, and what holds it at the wall behind.
Shape rod(double width, double height, double reach) {
  const double end = 0.5 * width + 0.1;
  Shape shape = tube({{-end, height, 0.0}, {end, height, 0.0}}, 0.02, 14);
  for (const double side : {-1.0, 1.0}) {
    append(shape, moved(ellipsoid({0.04, 0.036, 0.036}, 16), {side * (end + 0.02), height, 0.0}));
    append(shape, moved(turned(torus(0.024, 0.008, 16, 8), 90.0, {0, 0, 1}),
                        {side * (end - 0.02), height, 0.0}));
    append(shape, tube({{side * (end - 0.06), height, 0.0}, {side * (end - 0.06), height, -reach}},
                       0.012, 10));
  }
  return shape;
}

Shape rings(const Drapery& size, double height) {
  Shape shape;
  for (int i = 0; i <= size.folds; ++i) {
    const double x = size.width * (static_cast<double>(i) / size.folds - 0.5) * 0.985;
    append(shape,
           moved(turned(torus(0.032, 0.005, 12, 5), 90.0, {0, 0, 1}), {x, height - 0.012, 0.0}));
  }
  return shape;
}

/// A rope around the cloth's waist, with its two ends hanging in tassels.
Shape tie_rope(const Drapery& size) {
  const double y = -size.drop * (1.0 - size.tie_height);
  const double half = 0.5 * size.width * (1.0 - size.gather) + 0.02;
  std::vector<DVec3> loop;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2.0 * pi * i / 40.0;
    loop.emplace_back(half * std::sin(angle), y - 0.04 * std::cos(angle),
                      (size.fold_depth + 0.03) * std::cos(angle));
  }
  Shape rope = tube(loop, 0.014, 8);
  for (const double side : {-1.0, 1.0}) {
    const DVec3 knot(side * 0.03, y - 0.04, size.fold_depth + 0.035);
    const DVec3 end = knot + DVec3(side * 0.03, -0.24, 0.01);
    append(rope, tube({knot, glm::mix(knot, end, 0.5) + DVec3(0.0, 0.0, 0.012), end}, 0.009, 8));
    append(rope, moved(lathe({{0.0, -0.16},
                              {0.034, -0.155},
                              {0.028, -0.05},
                              {0.012, -0.03},
                              {0.022, -0.012},
                              {0.016, 0.008},
                              {0.0, 0.012}},
                             14),
                       end));
  }
  return rope;
}

struct Hanging {
  const char* name;
  int cloth;
  DVec3 place;
  double turn_deg;
};

}  // namespace

void add_cloths(Model& model, const Materials& m) {
  constexpr Drapery banner{.width = 1.7, .drop = 2.6, .folds = 3, .fold_depth = 0.05};
  constexpr Drapery curtain{
      .width = 2.2, .drop = 2.72, .folds = 8, .fold_depth = 0.085, .gather = 0.0};
  constexpr Drapery tied{
      .width = 2.2, .drop = 2.72, .folds = 8, .fold_depth = 0.085, .gather = 0.62};
  std::uint32_t number = 200;
  const auto hang = [&](const Hanging& hanging, std::vector<Part> parts) {
    for (Part& part : parts) {
      part.shape = moved(turned(part.shape, hanging.turn_deg), hanging.place);
    }
    add_object(model, hanging.name, parts);
  };
  constexpr double banner_height = upper_floor + 0.1;
  const std::vector<Hanging> banners = {
      {"Red banner", m.red_banner, {4.5, banner_height, -half_z + 0.53}, 0.0},
      {"Blue banner", m.blue_banner, {-4.5, banner_height, -half_z + 0.53}, 0.0},
      {"Far banner", m.blue_banner, {half_x - 0.53, banner_height, 0.0}, -90.0},
      {"Near banner", m.red_banner, {-half_x + 0.53, banner_height, 0.0}, 90.0}};
  for (const Hanging& hanging : banners) {
    const Shape cloth = drapery(banner, model.stream(number++));
    hang(hanging, {{hanging.cloth, cloth, 80.0},
                   {m.bronze, rod(banner.width, 0.03, 0.45), 50.0},
                   {m.rope, rings(banner, 0.03), 60.0},
                   {m.rope, fringe(banner, cloth, 0.09)}});
  }
  constexpr double rod_height = lower_springing - 0.16;
  const std::vector<Hanging> curtains = {
      {"Blue curtain", m.blue_cloth, {4.5, rod_height, half_z}, 180.0},
      {"Red curtain", m.red_cloth, {-1.5, rod_height, half_z}, 180.0},
      {"Side curtain", m.red_cloth, {-1.5, rod_height, -half_z}, 0.0},
      {"Corner curtain", m.blue_cloth, {7.5, rod_height, -half_z}, 0.0}};
  bool is_tied = true;
  for (const Hanging& hanging : curtains) {
    const Drapery& size = is_tied ? tied : curtain;
    std::vector<Part> parts = {{hanging.cloth, drapery(size, model.stream(number++)), 80.0},
                               {m.bronze, tube({{-1.36, 0.04, 0.0}, {1.36, 0.04, 0.0}}, 0.02, 14)},
                               {m.bronze, rings(size, 0.045), 60.0}};
    if (is_tied) {
      parts.push_back({m.rope, tie_rope(size), 50.0});
    }
    hang(hanging, parts);
    is_tied = !is_tied;
  }
}

}  // namespace foveola::scenes::arcade
