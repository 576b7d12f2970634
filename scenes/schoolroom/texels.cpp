// The parquet and the map: patterns that are computed a texel at a time.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "renderer/base/random.h"
#include "scenes/modelling/canvas.h"
#include "scenes/modelling/patterns.h"
#include "scenes/schoolroom/patterns.h"

namespace foveola::scenes::school {
namespace {

/// Coarse coasts: longitude and latitude in degrees.
const std::vector<std::vector<DVec2>>& coasts() {
  static const std::vector<std::vector<DVec2>> all = {
      // North America
      {{-167, 66}, {-156, 71}, {-128, 70}, {-110, 68}, {-95, 72},  {-82, 70},  {-82, 62},
       {-94, 59},  {-85, 55},  {-79, 52},  {-78, 62},  {-65, 60},  {-56, 52},  {-66, 49},
       {-60, 46},  {-70, 43},  {-75, 36},  {-81, 31},  {-80, 25},  {-84, 30},  {-94, 29},
       {-98, 20},  {-91, 18},  {-87, 21},  {-88, 16},  {-83, 14},  {-81, 8},   {-86, 12},
       {-96, 16},  {-106, 21}, {-113, 31}, {-110, 23}, {-117, 33}, {-124, 41}, {-124, 49},
       {-135, 58}, {-152, 60}, {-164, 55}, {-158, 59}},
      // South America
      {{-80, 7},
       {-72, 12},
       {-61, 10},
       {-50, 1},
       {-35, -6},
       {-39, -16},
       {-48, -27},
       {-57, -37},
       {-65, -42},
       {-68, -54},
       {-74, -50},
       {-73, -38},
       {-70, -20},
       {-81, -6},
       {-78, 1}},
      // Greenland, Iceland, Britain, Ireland
      {{-55, 82}, {-25, 83}, {-20, 74}, {-40, 65}, {-45, 60}, {-53, 67}, {-58, 75}},
      {{-24, 65}, {-15, 66}, {-15, 64}, {-22, 63}},
      {{-5, 58}, {-2, 57}, {1, 52}, {-5, 50}, {-3, 54}},
      {{-10, 54}, {-6, 55}, {-6, 52}, {-10, 52}},
      // Europe and Asia
      {{-9, 43},  {-1, 44},  {-2, 48},  {4, 52},   {8, 57},   {11, 54},  {20, 55},  {23, 59},
       {30, 60},  {22, 61},  {25, 65},  {18, 62},  {17, 57},  {12, 56},  {6, 59},   {12, 65},
       {25, 71},  {41, 67},  {45, 68},  {68, 69},  {75, 73},  {104, 78}, {130, 72}, {160, 70},
       {180, 68}, {178, 63}, {163, 60}, {157, 51}, {155, 59}, {136, 54}, {141, 51}, {129, 42},
       {129, 35}, {125, 39}, {118, 39}, {122, 31}, {116, 23}, {108, 21}, {109, 12}, {105, 9},
       {101, 13}, {104, 2},  {99, 9},   {95, 16},  {90, 22},  {80, 15},  {77, 8},   {72, 20},
       {66, 25},  {57, 26},  {50, 30},  {56, 24},  {59, 22},  {45, 13},  {35, 28},  {36, 36},
       {27, 37},  {29, 41},  {41, 41},  {38, 47},  {30, 46},  {28, 41},  {22, 37},  {20, 42},
       {13, 45},  {18, 40},  {16, 38},  {10, 44},  {3, 43},   {-1, 37},  {-9, 37}},
      // Africa, Madagascar
      {{-6, 36},
       {10, 37},
       {20, 31},
       {33, 31},
       {43, 12},
       {51, 12},
       {40, -4},
       {40, -15},
       {33, -28},
       {19, -35},
       {12, -17},
       {9, 1},
       {5, 5},
       {-8, 4},
       {-17, 14},
       {-16, 24}},
      {{44, -17}, {50, -15}, {47, -25}, {44, -23}},
      // Japan, Borneo, Sumatra, Java, New Guinea, Philippines
      {{130, 32}, {136, 34}, {141, 36}, {141, 43}, {145, 44}, {140, 45}, {139, 38}, {132, 35}},
      {{109, 1}, {117, 7}, {118, 1}, {115, -4}, {110, -3}},
      {{95, 5}, {104, -2}, {106, -6}, {100, -1}},
      {{105, -6}, {115, -8}, {108, -8}},
      {{131, -1}, {141, -3}, {150, -10}, {143, -9}, {138, -8}},
      {{120, 18}, {125, 11}, {126, 6}, {120, 14}},
      // Australia, New Zealand, Antarctica
      {{114, -22},
       {122, -18},
       {130, -12},
       {136, -12},
       {136, -16},
       {142, -11},
       {153, -27},
       {150, -37},
       {140, -38},
       {130, -32},
       {116, -35}},
      {{173, -35}, {178, -38}, {172, -44}, {167, -46}, {173, -41}},
      {{-181, -91},
       {181, -91},
       {181, -70},
       {150, -68},
       {90, -66},
       {40, -69},
       {0, -70},
       {-40, -78},
       {-60, -64},
       {-70, -73},
       {-120, -74},
       {-181, -78}},
  };
  return all;
}

/// The coasts' lines are straight; this makes them ragged.
DVec2 roughened(const DVec2& p) {
  return p + DVec2(1.3 * std::sin(0.55 * p.y + 0.3 * p.x) + 0.6 * std::sin(1.7 * p.y - p.x),
                   1.1 * std::sin(0.5 * p.x - 0.2 * p.y) + 0.5 * std::sin(1.9 * p.x + 0.7 * p.y));
}

/// A coast and the box around it, outside which nothing is tested.
struct Land {
  std::vector<DVec2> coast;
  DVec2 lower;
  DVec2 upper;
};

std::vector<Land> lands() {
  std::vector<Land> all;
  for (const std::vector<DVec2>& coast : coasts()) {
    Land land{coast, coast.front(), coast.front()};
    for (const DVec2& point : coast) {
      land.lower = glm::min(land.lower, point);
      land.upper = glm::max(land.upper, point);
    }
    all.push_back(std::move(land));
  }
  return all;
}

bool contains(const Land& land, const DVec2& p) {
  return p.x > land.lower.x && p.y > land.lower.y && p.x < land.upper.x && p.y < land.upper.y &&
         is_inside(p, land.coast);
}

/// Invented countries: the cells around points (Voronoi 1908), one anywhere in each field of a
/// lattice.
DVec3 country_color(const DVec2& p) {
  static constexpr std::array<DVec3, 6> palette = {DVec3(222, 190, 120), DVec3(176, 196, 120),
                                                   DVec3(226, 160, 130), DVec3(214, 208, 140),
                                                   DVec3(196, 160, 180), DVec3(160, 190, 160)};
  const DVec2 field_size(15.0, 12.0);
  const DVec2 field = glm::floor(p / field_size);
  double nearest = std::numeric_limits<double>::infinity();
  double second = nearest;
  std::uint32_t country = 0;
  for (int i = 0; i < 9; ++i) {
    const DVec2 neighbour = field + DVec2(i % 3 - 1, i / 3 - 1);
    const std::uint32_t key = mix(mix(74, static_cast<std::uint32_t>(std::lround(neighbour.x))),
                                  static_cast<std::uint32_t>(std::lround(neighbour.y)));
    const DVec2 capital = field_size * (neighbour + DVec2(unit_float(key), unit_float(mix(key))));
    const double distance = glm::distance(p, capital);
    if (distance < nearest) {
      second = nearest;
      nearest = distance;
      country = key;
    } else {
      second = std::min(second, distance);
    }
  }
  const bool is_border = second - nearest < 0.5;
  return is_border ? DVec3(150, 70, 60) : palette[country % palette.size()];
}

void set_color(Image& image, int x, int y, const DVec3& color) {
  std::uint8_t* const texel = &image.rgba[static_cast<std::size_t>(y * image.width + x) * 4];
  for (int channel = 0; channel < 3; ++channel) {
    texel[channel] = static_cast<std::uint8_t>(color[channel] + 0.5);
  }
}

double distance_to_multiple(double x, double step) {
  return std::abs(x - step * std::round(x / step));
}

/// One block of a herringbone floor on a lattice of block widths, each `length` cells long.
struct Block {
  bool lies_along_u = false;
  int number = 0;
  double along = 0.0;   ///< from its end, in cells
  double across = 0.0;  ///< from its edge, in [0, 1)
};

constexpr int block_length = 4;

Block block_at(double x, double y, int cells) {
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  constexpr int period = 2 * block_length;
  const int step = ((i - j) % period + period) % period;
  if (step < block_length) {
    const int start = (i - step + cells) % cells;
    return {true, start * cells + j, x - i + step, y - j};
  }
  // Blocks across start in the row where the step is greatest.
  const int from_start = period - 1 - step;
  const int start = (j - from_start + cells) % cells;
  return {false, (start + cells) * cells + i, y - j + from_start, x - i};
}

}  // namespace

Image parquet(int size, int blocks, const Seed& seed) {
  const Image grain = wood(512, 1, {0.4F, 0.23F, 0.11F}, {0.24F, 0.125F, 0.055F}, seed);
  Image image = blank(size, size, DVec3(0.0));
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Block block = block_at((x + 0.5) * blocks / size, (y + 0.5) * blocks / size, blocks);
      const std::uint32_t bits = mix(seed, static_cast<std::uint32_t>(block.number)).bits();
      const int column = static_cast<int>(bits % 512 + block.across * 100.0) % 512;
      const int row = static_cast<int>(bits / 512 % 512 + block.along * 50.0) % 512;
      const double from_edge =
          std::min({block.across, 1.0 - block.across, block.along, block_length - block.along});
      const double shade = (0.82 + 0.26 * unit_float(bits)) * (from_edge < 0.022 ? 0.45 : 1.0);
      const std::uint8_t* const wood_texel =
          &grain.rgba[static_cast<std::size_t>(row * 512 + column) * 4];
      const DVec3 color = shade * DVec3(wood_texel[0], wood_texel[1], wood_texel[2]);
      set_color(image, x, y, glm::min(color, DVec3(255.0)));
    }
  }
  return image;
}

Image world(int height) {
  const std::vector<Land> all = lands();
  Image image = blank(2 * height, height, DVec3(0.0));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < 2 * height; ++x) {
      const DVec2 p(180.0 * (x + 0.5) / height - 180.0, 90.0 - 180.0 * (y + 0.5) / height);
      const DVec2 on_coast = roughened(p);
      const bool is_land = std::any_of(all.begin(), all.end(),
                                       [&](const Land& land) { return contains(land, on_coast); });
      const double from_graticule =
          std::min(distance_to_multiple(p.x, 15.0), distance_to_multiple(p.y, 15.0));
      DVec3 color(150, 195, 220);
      if (is_land) {
        const bool is_icy = p.y < -62.0 || p.y > 76.0;
        color = is_icy ? DVec3(240, 242, 244) : country_color(on_coast);
      } else if (from_graticule < 0.18) {
        color = DVec3(110, 160, 195);
      }
      set_color(image, x, y, color);
    }
  }
  return image;
}

Image wall_map(int height) {
  Canvas canvas(world(height));
  const double h = height;
  const auto label = [&](const char* text, const DVec2& place, double size, const DVec3& color) {
    canvas.write(text, h * place, {.pen = {{color}, 0.12 * size * h}, .height = size * h});
  };
  const DVec3 black(45, 40, 45);
  label("NORTH AMERICA", {0.4, 0.26}, 0.02, black);
  label("SOUTH AMERICA", {0.6, 0.56}, 0.016, black);
  label("EUROPE", {1.09, 0.22}, 0.018, black);
  label("ASIA", {1.48, 0.24}, 0.028, black);
  label("AFRICA", {1.05, 0.45}, 0.024, black);
  label("AUSTRALIA", {1.69, 0.64}, 0.016, black);
  const DVec3 deep_blue(40, 80, 140);
  label("Pacific Ocean", {0.1, 0.55}, 0.026, deep_blue);
  label("Atlantic", {0.74, 0.4}, 0.022, deep_blue);
  label("Indian Ocean", {1.36, 0.62}, 0.022, deep_blue);
  const double margin = 0.045 * h;
  const double w = canvas.width();
  const Ink paper{{238, 230, 205}};
  canvas.fill_rectangle({0, 0}, {w, 2.0 * margin}, paper);
  canvas.fill_rectangle({0, h - margin}, {w, h}, paper);
  canvas.fill_rectangle({0, 0}, {margin, h}, paper);
  canvas.fill_rectangle({w - margin, 0}, {w, h}, paper);
  const DVec2 low(margin, 2.0 * margin);
  const DVec2 high(w - margin, h - margin);
  canvas.draw_lines({low, {high.x, low.y}, high, {low.x, high.y}, low}, {{black}, 0.006 * h});
  label("THE WORLD", {0.84, 0.068}, 0.042, {140, 35, 30});
  return std::move(canvas).finished();
}

}  // namespace foveola::scenes::school
