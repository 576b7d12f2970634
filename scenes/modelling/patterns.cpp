#include "scenes/modelling/patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/random.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes {
namespace {

using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here

}  // namespace

Image floor_tiles(int size, int tiles, const Rgb& first, const Rgb& second, const Seed& seed) {
  constexpr double joint = 0.025;
  return painted(size, size, [&](double u, double v) {
    const double x = u * tiles;
    const double y = v * tiles;
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const DVec3 color((column + row) % 2 == 0 ? first : second);
    const double shade = 0.85 + 0.3 * cell_value(column, row, seed);
    const double clouds = 0.8 + 0.4 * cloud(u, v, 3 * tiles, mix(seed, 1));
    const double from_joint = std::min(distance_to_integer(x), distance_to_integer(y));
    const double tile = smooth_step(0.5 * joint, joint, from_joint);
    return blend(DVec3(0.18), color * shade * clouds, tile);
  });
}

Image masonry(int size, const Masonry& masonry, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const double y = v * masonry.courses;
    const int course = static_cast<int>(y);
    const double x = u * masonry.stones + (course % 2 == 0 ? 0.0 : 0.5);
    const int stone = static_cast<int>(x) % masonry.stones;
    const double stone_length = static_cast<double>(masonry.courses) / masonry.stones;
    const double from_joint =
        std::min(distance_to_integer(x) * stone_length, distance_to_integer(y));
    const double roughness = cloud(u, v, 24, mix(seed, 1));
    const double shade = 1.0 + masonry.variation * (2.0 * cell_value(stone, course, seed) - 1.0);
    const double in_stone =
        smooth_step(0.5 * masonry.joint, masonry.joint, from_joint + 0.02 * (roughness - 0.5));
    const DVec3 color = DVec3(masonry.stone) * shade * (0.75 + 0.5 * roughness);
    return blend(DVec3(masonry.mortar), color, in_stone);
  });
}

Image wood(int size, int boards, const Rgb& light, const Rgb& dark, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const double x = u * boards;
    const int board = static_cast<int>(x);
    const Seed board_seed = mix(seed, static_cast<std::uint32_t>(board));
    const double bend = cloud(u, v, 2 * boards, 2, board_seed);
    const double rings = std::sin(2.0 * std::numbers::pi * (6.0 * x + 5.0 * bend));
    const double fibres = cloud(u, v, 64 * boards, 4, mix(board_seed, 1));
    const double grain = std::clamp(0.35 + 0.25 * rings + 0.5 * (fibres - 0.3), 0.0, 1.0);
    const double shade = 0.85 + 0.3 * cell_value(board, 0, seed);
    const double gap = smooth_step(0.004, 0.012, distance_to_integer(x));
    return blend(DVec3(light), DVec3(dark), grain) * shade * (0.35 + 0.65 * gap);
  });
}

Image plaster(int size, const Rgb& color, double variation, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const double coarse = cloud(u, v, 4, seed);
    const double fine = cloud(u, v, 40, mix(seed, 1));
    const double shade = 1.0 + variation * (1.4 * coarse + 0.6 * fine - 1.0);
    return DVec3(color) * shade;
  });
}

Image cloth(int size, int stripes, const Rgb& ground, const Rgb& stripe, const Seed& seed) {
  const double threads = size / 8.0;
  return painted(size, size, [&](double u, double v) {
    const double from_middle = distance_to_integer(u * stripes);
    const double band = 1.0 - smooth_step(0.12, 0.14, from_middle);
    const double hem = stroke(std::abs(from_middle - 0.2), 0.02, 0.004);
    const DVec3 color = blend(DVec3(ground), DVec3(stripe), std::max(band, hem));
    const double weave = std::sin(2.0 * std::numbers::pi * u * threads) *
                         std::sin(2.0 * std::numbers::pi * v * threads);
    const double wear = cloud(u, v, 6, seed);
    return color * (0.85 + 0.08 * weave + 0.3 * (wear - 0.35));
  });
}

Image ceiling_panels(int size, int panels, const Seed& seed) {
  constexpr int holes = 24;
  return painted(size, size, [&](double u, double v) {
    const double x = u * panels;
    const double y = v * panels;
    const double from_groove = std::min(distance_to_integer(x), distance_to_integer(y));
    const double groove = smooth_step(0.006, 0.014, from_groove);
    const DVec2 from_hole(distance_to_integer(x * holes + 0.5),
                          distance_to_integer(y * holes + 0.5));
    const double hole = 1.0 - smooth_step(0.1, 0.2, glm::length(from_hole));
    const double shade = 0.96 + 0.08 * cloud(u, v, 16, seed);
    return DVec3(0.72) * shade * (0.4 + 0.6 * groove) * (1.0 - 0.5 * hole * groove);
  });
}

Image leaf(int size, const Rgb& color, const Seed& seed) {
  constexpr double stalk_length = 0.12;
  return cut_out(size, size, [&](double u, double v) {
    const double along = 1.0 - v;
    const double across = u - 0.5;
    const double t = std::clamp((along - stalk_length) / (1.0 - stalk_length), 0.0, 1.0);
    const double half_width = 0.72 * std::sqrt(t) * (1.0 - t);
    const bool blade = along > stalk_length && std::abs(across) < half_width;
    const bool stalk = along <= stalk_length + 0.05 && std::abs(across) < 0.018;
    const double rib = stroke(std::abs(across), 0.03, 0.008);
    const double veins =
        stroke(distance_to_integer(9.0 * (along - 0.9 * std::abs(across))), 0.12, 0.05);
    const double shade = 0.75 + 0.5 * cloud(u, v, 5, seed);
    const DVec3 lighter = DVec3(color) * 1.6 + DVec3(0.03);
    return Texel{blend(DVec3(color) * shade, lighter, std::max(rib, 0.5 * veins)),
                 blade || stalk ? 1.0 : 0.0};
  });
}

Image written_board(int height, const Seed& seed) {
  constexpr double edge = 0.002;
  constexpr int lines = 9;
  const DVec3 black(0.03);
  const DVec3 blue(0.03, 0.08, 0.4);
  const DVec3 red(0.5, 0.04, 0.03);
  return painted(2 * height, height, [&](double u, double v) {
    const DVec2 p(2.0 * u, v);
    DVec3 color = DVec3(0.74) * (0.97 + 0.06 * cloud(u, v, 4, seed));
    const auto draw = [&](const DVec3& ink, double amount) { color = blend(color, ink, amount); };
    // Writing: on each line a wavering stroke, broken into words.
    const double y = (p.y - 0.12) / 0.085;
    const int line = static_cast<int>(std::floor(y));
    if (line >= 0 && line < lines && p.x > 0.1 && p.x < 0.95 - 0.25 * cell_value(line, 0, seed)) {
      const bool in_word = noise(p.x * 14.0, line, 1024, 1024, mix(seed, 1)) > 0.28;
      const double letters = noise(p.x * 70.0, line, 1024, 1024, mix(seed, 2)) - 0.5;
      const double height_in_line = y - line - 0.5;
      draw(line == 0 ? red : black,
           in_word ? stroke(std::abs(height_in_line - 0.75 * letters), 0.16, 0.05) : 0.0);
    }
    // A chart: axes and a rising line over bars.
    const DVec2 origin(1.12, 0.8);
    const DVec2 right(1.9, 0.8);
    const DVec2 up(1.12, 0.15);
    draw(black, stroke(distance_to_segment(p, origin, right), 0.01, edge));
    draw(black, stroke(distance_to_segment(p, origin, up), 0.01, edge));
    constexpr int bars = 6;
    const double bar_position = (p.x - origin.x) / (right.x - origin.x) * bars;
    const int bar = static_cast<int>(std::floor(bar_position));
    if (bar >= 0 && bar < bars && p.y < origin.y && bar_position - bar > 0.35) {
      const double top = origin.y - 0.1 - 0.07 * bar - 0.08 * cell_value(bar, 1, seed);
      draw(bar % 2 == 0 ? blue : red, p.y > top ? 0.8 : 0.0);
    }
    draw(black, stroke(distance_to_segment(p, {1.16, 0.66}, {1.86, 0.2}), 0.012, edge));
    return color;
  });
}

Image landscape(int size, const Seed& seed) {
  return painted(size, size, [&](double u, double v) {
    const DVec3 sky = blend({0.15, 0.3, 0.65}, {0.85, 0.6, 0.4}, smooth_step(0.0, 0.55, v));
    DVec3 color = sky;
    for (int ridge = 0; ridge < 4; ++ridge) {
      const double height = 0.42 + 0.13 * ridge - 0.2 * (cloud(u, 0.5, 3, mix(seed, ridge)) - 0.4);
      const DVec3 hill = blend({0.3, 0.35, 0.45}, {0.08, 0.18, 0.04}, ridge / 3.0);
      color = blend(color, hill, smooth_step(height, height + 0.01, v));
    }
    return color;
  });
}

Image clock_face(int size) {
  constexpr double edge = 0.004;
  return painted(size, size, [&](double u, double v) {
    const DVec2 p(u - 0.5, 0.5 - v);
    const double radius = glm::length(p);
    const double turn = std::atan2(p.x, p.y) / (2.0 * std::numbers::pi);
    const double from_hour = distance_to_integer(12.0 * turn) / 12.0 * 2.0 * std::numbers::pi;
    const double mark =
        radius > 0.36 && radius < 0.44 ? stroke(from_hour * radius, 0.025, edge) : 0.0;
    const auto hand = [&](double turn_of_hand, double length, double width) {
      const double angle = 2.0 * std::numbers::pi * turn_of_hand;
      const DVec2 tip = length * DVec2(std::sin(angle), std::cos(angle));
      return stroke(distance_to_segment(p, {0.0, 0.0}, tip), width, edge);
    };
    constexpr double ten_past_ten = (10.0 + 1.0 / 6.0) / 12.0;
    const double ink =
        std::max({mark, hand(ten_past_ten, 0.24, 0.035), hand(1.0 / 6.0, 0.36, 0.022)});
    return blend(DVec3(0.78), DVec3(0.03), ink);
  });
}

}  // namespace foveola::scenes
