// The painted figures of the church: its stained glass and its saints on gold.
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/base/random.h"
#include "scenes/church/patterns.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes {
namespace {

using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here

// How much light coloured glass lets through.
const DVec3 ruby(0.5, 0.006, 0.008);
const DVec3 cobalt(0.008, 0.02, 0.36);
const DVec3 sky_blue(0.03, 0.11, 0.45);
const DVec3 emerald(0.008, 0.2, 0.03);
const DVec3 amber(0.6, 0.22, 0.01);
const DVec3 rose(0.45, 0.06, 0.1);
const DVec3 clear(0.8, 0.76, 0.58);
const DVec3 lead(0.004);

DVec3 jewel(int i, int j, const Seed& seed) {
  const std::array<DVec3, 6> glasses = {ruby, cobalt, sky_blue, emerald, amber, rose};
  return glasses.at(static_cast<std::size_t>(6.0 * cell_value(i, j, seed)));
}

/// Glass of uneven thickness.
DVec3 uneven(const DVec3& glass, double u, double v, const Seed& seed) {
  return glass * (0.7 + 0.6 * cloud(u, v, 9, seed));
}

/// A colour that figures are laid over one after the other, each with a dark outline.
struct Layers {
  DVec3 color{0.0};
  DVec3 line{0.0};          ///< the outlines' colour
  double line_width = 0.0;  ///< around what is laid
  double edge = 0.0;        ///< over which outlines are soft

  void lay(double distance, const DVec3& with) {
    color = blend(color, with, inside(distance, edge));
    draw(std::abs(distance), line_width);
  }
  void draw(double distance, double width) {
    color = blend(color, line, inside(distance - 0.5 * width, edge));
  }
};

struct SaintColors {
  DVec3 robe;
  DVec3 cloak;
  DVec3 halo;
  DVec3 skin;
};

/// A saint who stands on y = 0.3 and is about three high, with a staff and a book.
void lay_saint(Layers& layers, const DVec2& p, const SaintColors& colors) {
  const DVec2 mirrored(std::abs(p.x), p.y);
  layers.lay(to_circle(p - DVec2(0.0, 3.0), 0.46), colors.halo);
  layers.lay(to_limb(p, {0.66, 0.3}, {0.66, 3.2}, 0.04, 0.04), colors.halo);
  const double cloak = to_limb(p, {0.0, 2.25}, {0.0, 0.85}, 0.5, 0.62);
  layers.lay(cloak, colors.cloak);
  const double robe = to_limb(p, {0.0, 2.35}, {0.0, 0.62}, 0.3, 0.4);
  layers.lay(robe, colors.robe);
  if (robe < 0.0) {
    const double fold = distance_to_integer(4.2 * p.x + 0.35 * std::sin(2.4 * p.y));
    layers.draw(fold / 4.2, 0.4 * layers.line_width + 0.02 * std::max(0.0, 1.8 - p.y));
    layers.draw(std::abs(p.y - 1.75), 0.08);
  }
  layers.lay(to_limb(mirrored, {0.42, 2.3}, {0.3, 1.75}, 0.17, 0.13), colors.cloak);
  layers.lay(to_rectangle(p - DVec2(-0.12, 1.95), {0.17, 0.22}), colors.halo);
  layers.lay(to_circle(mirrored - DVec2(0.28, 1.85), 0.1), colors.skin);
  layers.lay(to_limb(p, {0.0, 3.06}, {0.0, 2.92}, 0.21, 0.16), colors.skin);
  layers.lay(std::max(to_circle(p - DVec2(0.0, 3.1), 0.24), 3.12 - p.y), colors.robe * 0.5);
  layers.draw(to_circle(mirrored - DVec2(0.08, 3.02), 0.015), 0.02);
  layers.draw(to_limb(p, {-0.05, 2.86}, {0.05, 2.86}, 0.008, 0.008), 0.02);
}

/// Coloured pieces, `pieces` of them along `position` in [0, 1], within `width` of the edge.
void lay_border(Layers& layers, double from_edge, double position, double width, int pieces,
                const Seed& seed) {
  if (from_edge > width + layers.line_width) {
    return;
  }
  const int piece = static_cast<int>(std::floor(position * pieces));
  layers.lay(from_edge - width, piece % 2 == 0 ? jewel(piece, 3, seed) : clear * 0.8);
  layers.draw(distance_to_integer(position * pieces) * 2.0 * width, layers.line_width);
}

/// Lozenges as high as 1.6 times their width, `across` of them over the unit length.
struct Lozenge {
  double from_edge;
  int i;
  int j;
};
Lozenge lozenge(const DVec2& p, double across) {
  const double a = across * (p.x + p.y / 1.6);
  const double b = across * (p.x - p.y / 1.6);
  return {std::min(distance_to_integer(a), distance_to_integer(b)) / across,
          static_cast<int>(std::floor(a)), static_cast<int>(std::floor(b))};
}

}  // namespace

Image figure_window(int width, const Rgb& robe, const Seed& seed) {
  return painted(width, 4 * width, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 8.0 * (1.0 - v));
    Layers layers{.line = lead, .line_width = 0.045, .edge = 0.012};
    const Lozenge piece = lozenge(p, 3.0);
    layers.color = cell_value(piece.i, piece.j, seed) < 0.75 ? cobalt : sky_blue * 0.6;
    layers.draw(piece.from_edge, 0.035);
    // Below the saint a panel of two medallions, above it the canopy.
    for (const double middle : {0.95, 2.25}) {
      const DVec2 q = p - DVec2(0.0, middle);
      layers.lay(to_foil(q, 4, 0.26, 0.3), ruby);
      layers.lay(to_foil(q, 8, 0.2, 0.1), amber);
      layers.lay(to_circle(q, 0.14), emerald);
    }
    layers.lay(to_rectangle(p - DVec2(0.0, 3.1), {0.8, 0.12}), amber);
    lay_saint(layers, p - DVec2(0.0, 2.95), {DVec3(robe), ruby, amber, rose * 0.6 + clear * 0.4});
    const DVec2 above = p - DVec2(0.0, 6.7);
    const double gable = std::abs(above.x) * 0.86 + (above.y - 0.8) * 0.5;
    const double canopy = std::max({gable, -to_foil(above, 3, 0.12, 0.5), 0.0 - above.y});
    layers.lay(canopy, amber * 0.8 + clear * 0.2);
    layers.lay(to_foil(p - DVec2(0.0, 7.35), 4, 0.1, 0.12), ruby);
    lay_border(layers, 1.0 - std::abs(p.x), 1.0 - v, 0.14, 26, seed);
    return uneven(layers.color, u, v, mix(seed, 1));
  });
}

Image grisaille_window(int width, const Seed& seed) {
  return painted(width, 3 * width, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 6.0 * (1.0 - v));
    Layers layers{.line = lead, .line_width = 0.045, .edge = 0.012};
    const Lozenge piece = lozenge(p, 3.0);
    const double tone = cell_value(piece.i, piece.j, seed);
    layers.color = tone < 0.12 ? amber : clear * (0.6 + 0.4 * tone);
    layers.draw(piece.from_edge, 0.04);
    for (int k = 0; k < 4; ++k) {
      const DVec2 q = p - DVec2(0.0, 0.8 + 1.4 * k);
      const DVec3 first = k % 2 == 0 ? ruby : cobalt;
      const DVec3 second = k % 2 == 0 ? cobalt : emerald;
      layers.lay(to_foil(q, 4, 0.3, 0.26), first);
      layers.lay(to_circle(q, 0.34), amber);
      layers.lay(to_foil(q, 6, 0.17, 0.1), second);
      layers.lay(to_circle(q, 0.1), clear);
    }
    lay_border(layers, 1.0 - std::abs(p.x), 1.0 - v, 0.16, 22, mix(seed, 2));
    return uneven(layers.color, u, v, mix(seed, 1));
  });
}

Image rose_window(int size, const Seed& seed) {
  constexpr int petals = 12;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 1.0 - 2.0 * v);
    const double radius = glm::length(p);
    Layers layers{.color = cobalt, .line = lead, .line_width = 0.014, .edge = 0.004};
    const DVec2 q = in_sector(p, petals);
    const int petal = sector_of(p, petals);
    const DVec3 hue = petal % 3 == 0 ? ruby : petal % 3 == 1 ? amber : emerald;
    const DVec2 between = in_sector(DVec2(p.x * std::cos(0.2618) - p.y * std::sin(0.2618),
                                          p.x * std::sin(0.2618) + p.y * std::cos(0.2618)),
                                    petals);
    layers.draw(distance_to_integer(radius * 16.0) / 16.0, 0.01);
    layers.lay(to_circle(between - DVec2(0.0, 0.86), 0.085), ruby);
    layers.lay(to_foil(between - DVec2(0.0, 0.86), 4, 0.03, 0.03), clear);
    layers.lay(to_limb(q, {0.0, 0.36}, {0.0, 0.74}, 0.06, 0.155), sky_blue);
    layers.lay(to_limb(q, {0.0, 0.38}, {0.0, 0.73}, 0.03, 0.11), hue);
    layers.lay(to_foil(q - DVec2(0.0, 0.72), 6, 0.045, 0.032), clear);
    layers.lay(to_circle(q - DVec2(0.0, 0.72), 0.03), rose);
    layers.lay(to_circle(p, 0.28), ruby);
    layers.lay(to_foil(p, 6, 0.14, 0.1), sky_blue);
    layers.lay(to_foil(p, 6, 0.13, 0.05), amber);
    layers.lay(to_circle(p, 0.08), clear);
    return uneven(layers.color, u, v, seed);
  });
}

Image painted_saint(int width, const Rgb& robe, const Seed& seed) {
  return painted(width, 2 * width, [&](double u, double v) {
    const DVec2 p(2.0 * u - 1.0, 4.0 * (1.0 - v));
    Layers layers{.line = DVec3(0.06, 0.03, 0.015), .line_width = 0.03, .edge = 0.012};
    const Lozenge tooled = lozenge(p, 5.0);
    const double gilding = 0.75 + 0.5 * cloud(u, v, 8, seed);
    layers.color = DVec3(0.66, 0.42, 0.1) * gilding * (tooled.from_edge < 0.012 ? 0.7 : 1.0);
    layers.lay(p.y - 0.4, {0.09, 0.1, 0.05});
    const DVec3 cloak = DVec3(robe.b, robe.r, robe.g) * 0.8;
    lay_saint(layers, p - DVec2(0.0, 0.15),
              {DVec3(robe), cloak, {0.85, 0.62, 0.2}, {0.55, 0.33, 0.22}});
    const double from_frame = std::min({1.0 - std::abs(p.x), p.y, 4.0 - p.y});
    layers.lay(from_frame - 0.06, {0.3, 0.04, 0.03});
    return layers.color * (0.85 + 0.3 * cloud(u, v, 20, mix(seed, 1)));
  });
}

}  // namespace foveola::scenes
