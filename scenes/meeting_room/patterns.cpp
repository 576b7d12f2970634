#include "scenes/meeting_room/patterns.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "renderer/base/random.h"
#include "scenes/modelling/canvas.h"
#include "scenes/modelling/painting.h"

namespace foveola::scenes::meeting {
namespace {

// Of sRGB-encoded bytes, as the canvas takes them.
const DVec3 black(28.0, 30.0, 36.0);
const DVec3 blue(26.0, 62.0, 168.0);
const DVec3 red(192.0, 34.0, 28.0);
const DVec3 green(20.0, 120.0, 60.0);

Pen marker(const DVec3& color, double width) { return {{color, 0.9, 0.1}, width}; }

TextStyle handwriting(const DVec3& color, double height) {
  return {.pen = marker(color, 0.14 * height), .height = height, .slant = 0.1};
}

void write_lines(Canvas& canvas, const std::vector<std::string_view>& lines, DVec2 from,
                 const TextStyle& style, double line_height) {
  for (const std::string_view line : lines) {
    canvas.write(line, from, style);
    from.y += line_height;
  }
}

void draw_box(Canvas& canvas, const DVec2& corner, const DVec2& size, const Pen& pen) {
  canvas.draw_lines(
      {corner, corner + DVec2(size.x, 0.0), corner + size, corner + DVec2(0.0, size.y), corner},
      pen);
}

void draw_arrow(Canvas& canvas, const DVec2& from, const DVec2& to, const Pen& pen) {
  const DVec2 along = glm::normalize(to - from) * 5.0 * pen.width;
  const DVec2 across(-0.6 * along.y, 0.6 * along.x);
  canvas.draw_lines({from, to}, pen);
  canvas.draw_lines({to - along + across, to, to - along - across}, pen);
}

/// Axes, bars and a rising line; h is the unit of length.
void draw_chart(Canvas& canvas, const DVec2& origin, double h) {
  const Pen axis = marker(black, 0.008 * h);
  draw_arrow(canvas, origin, origin + DVec2(0.62 * h, 0.0), axis);
  draw_arrow(canvas, origin, origin - DVec2(0.0, 0.44 * h), axis);
  std::vector<DVec2> line;
  for (int i = 0; i < 6; ++i) {
    const double x = origin.x + (0.06 + 0.09 * i) * h;
    const double top = (0.1 + 0.045 * i + 0.03 * std::sin(2.0 * i)) * h;
    canvas.fill_rectangle({x, origin.y - top}, {x + 0.05 * h, origin.y - 0.006 * h},
                          {i % 2 == 0 ? blue : green, 0.75, 0.3});
    line.emplace_back(x + 0.025 * h, origin.y - top - 0.05 * h);
  }
  canvas.draw_lines(line, marker(red, 0.009 * h));
  for (const DVec2& point : line) {
    canvas.fill_circle(point, 0.011 * h, {red, 1.0, 0.0});
  }
}

}  // namespace

Image discussed_board(int height) {
  const double h = height;
  Canvas canvas(blank(2 * height, height, {236.0, 238.0, 238.0}));
  // Old writing that was never quite wiped off.
  canvas.write("budget Q3?", {0.9 * h, 0.9 * h},
               {.pen = {{DVec3(170.0, 180.0, 200.0), 0.35, 0.5}, 0.01 * h},
                .height = 0.06 * h,
                .slant = 0.1});
  canvas.write("Project review", {0.08 * h, 0.16 * h}, handwriting(red, 0.075 * h));
  canvas.draw_lines({{0.08 * h, 0.195 * h}, {0.5 * h, 0.19 * h}, {0.78 * h, 0.198 * h}},
                    marker(red, 0.008 * h));
  write_lines(canvas,
              {"1. Results of week 46", "2. Users: 16 + 8 more", "3. Gaze data - errors?",
               "4. Paper: figures 5, 6", "5. Next steps"},
              {0.1 * h, 0.3 * h}, handwriting(black, 0.046 * h), 0.098 * h);
  write_lines(canvas, {"Anna: protocol", "Ben: scenes", "Kim: statistics"}, {0.14 * h, 0.8 * h},
              handwriting(blue, 0.038 * h), 0.07 * h);
  draw_chart(canvas, {1.08 * h, 0.56 * h}, h);
  canvas.write("time", {1.62 * h, 0.62 * h}, handwriting(black, 0.032 * h));
  canvas.write("quality", {1.12 * h, 0.12 * h}, handwriting(black, 0.036 * h));
  const Pen pen = marker(blue, 0.008 * h);
  const std::array<std::string_view, 3> steps = {"eye", "view", "film"};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const DVec2 corner((1.02 + 0.31 * static_cast<double>(i)) * h, 0.72 * h);
    draw_box(canvas, corner, {0.2 * h, 0.13 * h}, pen);
    canvas.write(steps[i], corner + DVec2(0.035, 0.085) * h, handwriting(black, 0.042 * h));
    if (i + 1 < steps.size()) {
      draw_arrow(canvas, corner + DVec2(0.21, 0.065) * h, corner + DVec2(0.3, 0.065) * h, pen);
    }
  }
  canvas.draw_circle({1.74 * h, 0.785 * h}, 0.15 * h, marker(red, 0.007 * h));
  return std::move(canvas).finished();
}

Image flip_chart_sheet(int height) {
  const double h = height;
  Canvas canvas(blank(3 * height / 4, height, {240.0, 239.0, 232.0}));
  canvas.write("Ideas", {0.08 * h, 0.16 * h}, handwriting(blue, 0.08 * h));
  canvas.draw_lines({{0.08 * h, 0.2 * h}, {0.38 * h, 0.195 * h}}, marker(blue, 0.01 * h));
  write_lines(canvas,
              {"+ faster preview", "+ fewer samples", "- blur at the edge", "- head turns",
               "? colour vision"},
              {0.08 * h, 0.32 * h}, handwriting(black, 0.042 * h), 0.095 * h);
  canvas.draw_circle({0.37 * h, 0.86 * h}, 0.08 * h, marker(red, 0.008 * h));
  canvas.draw_circle({0.37 * h, 0.86 * h}, 0.035 * h, marker(green, 0.008 * h));
  canvas.fill_circle({0.37 * h, 0.86 * h}, 0.016 * h, {black, 1.0, 0.0});
  return std::move(canvas).finished();
}

Image printed_page(int height) {
  const double h = height;
  Canvas canvas(blank(3 * height / 4, height, {243.0, 242.0, 238.0}));
  const auto print = [&](double size) {
    return TextStyle{.pen = {{black, 1.0, 0.0}, 0.13 * size}, .height = size};
  };
  canvas.write("Agenda", {0.07 * h, 0.12 * h}, print(0.045 * h));
  canvas.draw_lines({{0.07 * h, 0.15 * h}, {0.68 * h, 0.15 * h}}, {{black, 1.0, 0.0}, 0.003 * h});
  for (int paragraph = 0; paragraph < 4; ++paragraph) {
    const double y = (0.22 + 0.18 * paragraph) * h;
    write_lines(canvas,
                {"Review of the study and of", "its results, with figures and",
                 "tables of all participants", "and the list of questions."},
                {0.07 * h, y}, print(0.019 * h), 0.037 * h);
  }
  return std::move(canvas).finished();
}

Image laptop_desktop(int height) {
  const double h = height;
  Canvas canvas(blank(8 * height / 5, height, {44.0, 78.0, 128.0}));
  canvas.fill_rectangle({0.0, 0.94 * h}, {1.6 * h, h}, {DVec3(24.0, 28.0, 38.0), 1.0, 0.0});
  for (int i = 0; i < 6; ++i) {
    canvas.fill_rectangle(
        {(0.03 + 0.07 * i) * h, 0.952 * h}, {(0.07 + 0.07 * i) * h, 0.988 * h},
        {i % 2 == 0 ? DVec3(90.0, 150.0, 220.0) : DVec3(220.0, 150.0, 70.0), 1.0, 0.0});
  }
  canvas.fill_rectangle({0.08 * h, 0.06 * h}, {1.52 * h, 0.9 * h},
                        {DVec3(236.0, 238.0, 242.0), 1.0, 0.0});
  canvas.fill_rectangle({0.08 * h, 0.06 * h}, {1.52 * h, 0.12 * h},
                        {DVec3(60.0, 66.0, 80.0), 1.0, 0.0});
  const TextStyle text{.pen = {{black, 1.0, 0.0}, 0.004 * h}, .height = 0.028 * h};
  canvas.write("Results of the study", {0.14 * h, 0.2 * h},
               {.pen = {{blue, 1.0, 0.0}, 0.007 * h}, .height = 0.04 * h});
  write_lines(
      canvas,
      {"All sixteen persons", "took part in it and", "saw each scene with", "three methods. The",
       "preview that follows", "the eye was faster", "in every scene by a", "factor of ten."},
      {0.14 * h, 0.3 * h}, text, 0.065 * h);
  draw_chart(canvas, {0.82 * h, 0.72 * h}, h);
  return std::move(canvas).finished();
}

Image abstract_painting(int height, const Seed& seed) {
  using namespace paint;  // NOLINT(google-build-using-namespace): its every name is drawn with here
  const std::array<DVec3, 5> colors = {DVec3(0.55, 0.12, 0.05), DVec3(0.62, 0.4, 0.08),
                                       DVec3(0.06, 0.16, 0.3), DVec3(0.1, 0.3, 0.27),
                                       DVec3(0.04, 0.04, 0.06)};
  return painted(4 * height / 3, height, [&](double u, double v) {
    const DVec2 wander(cloud(u, v, 6, seed), cloud(u, v, 6, mix(seed, 1)));
    const DVec2 p = DVec2(4.0 * u / 3.0, v) + 0.05 * (wander - DVec2(0.5));
    DVec3 color = DVec3(0.68, 0.62, 0.5) * (0.85 + 0.3 * cloud(u, v, 12, mix(seed, 2)));
    for (int i = 0; i < 9; ++i) {
      const DVec2 middle(1.33 * cell_value(i, 0, seed), cell_value(i, 1, seed));
      const DVec2 half(0.08 + 0.2 * cell_value(i, 2, seed), 0.06 + 0.2 * cell_value(i, 3, seed));
      const double amount = inside(
          i % 3 == 2 ? to_circle(p - middle, half.x) : to_rectangle(p - middle, half), 0.004);
      const double strokes =
          0.65 + 0.35 * cloud(u, 0.2 * v, 32, mix(seed, static_cast<std::uint32_t>(10 + i)));
      color = blend(color, colors.at(static_cast<std::size_t>(i % 5)), amount * strokes);
    }
    return color * (0.9 + 0.2 * cloud(u, v, 48, mix(seed, 3)));
  });
}

}  // namespace foveola::scenes::meeting
