#include "scenes/schoolroom/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "renderer/base/random.h"
#include "scenes/modelling/canvas.h"
#include "scenes/modelling/patterns.h"

namespace foveola::scenes::school {
namespace {

using std::numbers::pi;

const DVec3 white_chalk(236, 236, 228);
const DVec3 yellow_chalk(240, 220, 120);
const DVec3 red_chalk(230, 140, 125);
const DVec3 blue_chalk(140, 190, 230);

constexpr std::array words = {"the",  "river", "runs", "to",    "sea",   "and",  "a",    "small",
                              "boat", "on",    "its",  "water", "moves", "with", "wind", "under",
                              "many", "stars", "in",   "light", "of",    "moon", "old",  "bridge",
                              "far",  "hill",  "we",   "walk",  "home",  "late"};

/// Words up to about `letters` letters.
std::string sentence(Pcg32& random, std::size_t letters) {
  std::string text;
  while (text.size() + 6 < letters) {
    text += text.empty() ? "" : " ";
    text += words[random.below(words.size())];
  }
  return text;
}

/// A slate, not quite wiped clean. Positions drawn on it are in heights of the board.
class Slate {
 public:
  Slate(int width, int height, const Seed& seed)
      : canvas_(blank(width, height, {38, 62, 54})), height_(height) {
    Pcg32 random = generator(seed);
    for (int i = 0; i < 60; ++i) {
      // In braces: compilers disagree on the order of a call's arguments.
      const DVec2 from{random.uniform() * width, random.uniform() * height};
      const DVec2 along{height * (0.15 + 0.2 * random.uniform()),
                        height * 0.12 * (random.uniform() - 0.5)};
      canvas_.draw_lines({from, from + along}, {{{150, 165, 155}, 0.03}, 0.09 * height});
    }
  }

  DVec2 write(std::string_view text, const DVec2& from, double size, const DVec3& color) {
    const TextStyle style{.pen = pen(color), .height = size * height_, .slant = 0.12};
    return canvas_.write(text, from * height_, style) / height_;
  }

  void lines(std::vector<DVec2> points, const DVec3& color) {
    for (DVec2& point : points) {
      point *= height_;
    }
    canvas_.draw_lines(points, pen(color));
  }

  void hatch(std::vector<DVec2> corners, const DVec3& color) {
    for (DVec2& corner : corners) {
      corner *= height_;
    }
    canvas_.fill_polygon(corners, {color, 0.3, 0.9});
  }

  Image finished() && { return std::move(canvas_).finished(); }

 private:
  Pen pen(const DVec3& color) const { return {{color, 0.95, 0.45}, 0.007 * height_}; }

  Canvas canvas_;
  double height_;
};

/// Colours in both rows and columns of a sheet of eight, calling paint(canvas, corner, size, i).
template <typename Paint>
Image sheets(int height, const Paint& paint) {
  Canvas canvas(blank(3 * height / 2, height, {236, 232, 220}));
  const DVec2 size(static_cast<double>(canvas.width()) / sheets_across,
                   static_cast<double>(canvas.height()) / sheets_down);
  for (int i = 0; i < sheets_across * sheets_down; ++i) {
    paint(canvas, size * DVec2(i % sheets_across, i / sheets_across), size, i);
  }
  return std::move(canvas).finished();
}

void draw_timetable(Canvas& canvas, const DVec2& corner, const DVec2& size) {
  const Pen line{{{60, 60, 70}}, 0.008 * size.x};
  for (int i = 0; i <= 5; ++i) {
    const double x = corner.x + size.x * (0.1 + 0.16 * i);
    canvas.draw_lines({{x, corner.y + 0.25 * size.y}, {x, corner.y + 0.9 * size.y}}, line);
  }
  constexpr std::array subjects = {"Art", "Math", "Bio", "Sport", "Music", "Text"};
  for (int row = 0; row <= 6; ++row) {
    const double y = corner.y + size.y * (0.25 + 0.108 * row);
    canvas.draw_lines({{corner.x + 0.1 * size.x, y}, {corner.x + 0.9 * size.x, y}}, line);
    for (int i = 0; row < 6 && i < 5; ++i) {
      canvas.write(subjects[(row * 7 + i * 5 + row * i) % subjects.size()],
                   {corner.x + size.x * (0.12 + 0.16 * i), y + 0.07 * size.y},
                   {.pen = {{{30, 40, 120}}, 0.007 * size.x}, .height = 0.035 * size.y});
    }
  }
}

void write_paragraphs(Canvas& canvas, const DVec2& corner, const DVec2& size, const Seed& seed) {
  Pcg32 random = generator(seed);
  for (int line = 0; line < 11; ++line) {
    const std::size_t letters = line % 4 == 3 ? 14 : 28;
    canvas.write(sentence(random, letters), corner + size * DVec2(0.1, 0.3 + 0.058 * line),
                 {.pen = {{{50, 50, 55}}, 0.007 * size.x}, .height = 0.03 * size.y});
  }
}

void draw_sun(Canvas& canvas, const DVec2& middle, double radius) {
  const Ink yellow{{240, 190, 30}, 0.95, 0.3};
  canvas.fill_circle(middle, radius, yellow);
  for (int ray = 0; ray < 10; ++ray) {
    const double angle = 2.0 * pi * ray / 10.0;
    const DVec2 out(std::cos(angle), std::sin(angle));
    canvas.draw_lines({middle + 1.3 * radius * out, middle + 1.9 * radius * out},
                      {yellow, 0.18 * radius});
  }
}

void draw_house(Canvas& canvas, const DVec2& foot, double side, const DVec3& color) {
  const Pen outline{{{50, 40, 40}, 0.9, 0.4}, 0.04 * side};
  canvas.fill_rectangle(foot - DVec2(0, side), foot + DVec2(side, 0), {color, 0.85, 0.5});
  const std::vector<DVec2> roof = {foot + DVec2(-0.15 * side, -side),
                                   foot + DVec2(0.5 * side, -1.7 * side),
                                   foot + DVec2(1.15 * side, -side)};
  canvas.fill_polygon(roof, {{190, 60, 45}, 0.85, 0.5});
  canvas.draw_lines({roof[0], roof[1], roof[2], roof[0]}, outline);
  canvas.fill_rectangle(foot + DVec2(0.4, -0.5) * side, foot + DVec2(0.62, 0.0) * side,
                        {{95, 60, 40}, 0.9, 0.3});
  for (const double x : {0.1, 0.7}) {
    canvas.fill_rectangle(foot + DVec2(x, -0.8) * side, foot + DVec2(x + 0.2, -0.55) * side,
                          {{120, 190, 230}, 0.9, 0.3});
  }
}

void draw_tree(Canvas& canvas, const DVec2& foot, double height) {
  canvas.fill_rectangle(foot + DVec2(-0.06, -0.5) * height, foot + DVec2(0.06, 0.0) * height,
                        {{110, 70, 40}, 0.9, 0.4});
  for (const DVec2& crown : {DVec2(-0.16, -0.6), DVec2(0.16, -0.62), DVec2(0.0, -0.8)}) {
    canvas.fill_circle(foot + crown * height, 0.22 * height, {{50, 140, 55}, 0.85, 0.5});
  }
}

void draw_person(Canvas& canvas, const DVec2& foot, double height, const DVec3& color) {
  const Pen pen{{color, 0.95, 0.3}, 0.045 * height};
  const auto at = [&](double x, double y) { return foot + height * DVec2(x, -y); };
  canvas.draw_circle(at(0.0, 0.86), 0.13 * height, pen);
  canvas.draw_lines({at(0.0, 0.72), at(0.0, 0.35)}, pen);
  canvas.draw_lines({at(-0.2, 0.0), at(0.0, 0.35), at(0.2, 0.0)}, pen);
  canvas.draw_lines({at(-0.26, 0.62), at(0.0, 0.55), at(0.26, 0.66)}, pen);
}

}  // namespace

Image board_middle(int height, const Seed& seed) {
  Slate slate(2 * height, height, seed);
  slate.write("The theorem of Pythagoras", {0.1, 0.14}, 0.075, yellow_chalk);
  slate.lines({{0.1, 0.165}, {1.18, 0.17}}, yellow_chalk);
  const DVec2 right_angle(0.5, 0.66);
  const DVec2 up(0.0, -0.165);
  const DVec2 right(0.225, 0.0);
  const DVec2 a_end = right_angle + up;
  const DVec2 b_end = right_angle + right;
  const DVec2 across(0.165, -0.225);  // the hypotenuse turned by a right angle
  const DVec2 left(up.y, 0.0);
  const DVec2 down(0.0, right.x);
  slate.hatch({right_angle, a_end, a_end + left, right_angle + left}, red_chalk);
  slate.hatch({right_angle, b_end, b_end + down, right_angle + down}, blue_chalk);
  slate.lines({right_angle, a_end, b_end, right_angle}, white_chalk);
  slate.lines({a_end, a_end + left, right_angle + left, right_angle}, red_chalk);
  slate.lines({b_end, b_end + down, right_angle + down, right_angle}, blue_chalk);
  slate.lines({a_end, a_end + across, b_end + across, b_end}, yellow_chalk);
  slate.write("a", {0.4, 0.595}, 0.05, white_chalk);
  slate.write("b", {0.595, 0.8}, 0.05, white_chalk);
  slate.write("c", {0.68, 0.49}, 0.05, white_chalk);
  const auto squares = [&](const DVec2& from, double size, const DVec3& color) {
    DVec2 pen = from;
    for (const char* const term : {"a", " + b", " = c"}) {
      pen = slate.write(term, pen, size, color);
      pen = slate.write("2", pen - DVec2(0.0, 0.05), 0.5 * size, color) + DVec2(0.0, 0.05);
    }
  };
  squares({1.25, 0.36}, 0.085, white_chalk);
  slate.write("3 x 3 + 4 x 4 = c x c", {1.25, 0.5}, 0.055, white_chalk);
  slate.write("9 + 16 = 25", {1.25, 0.61}, 0.055, white_chalk);
  slate.write("c = 5", {1.25, 0.73}, 0.07, red_chalk);
  slate.lines({{1.24, 0.755}, {1.46, 0.75}}, red_chalk);
  slate.write("and if a = 5, b = 12?", {1.25, 0.88}, 0.05, blue_chalk);
  return std::move(slate).finished();
}

Image board_left(int height, const Seed& seed) {
  Slate slate(height, height, seed);
  slate.write("Monday, 14 May", {0.08, 0.13}, 0.06, white_chalk);
  slate.write("Homework", {0.08, 0.29}, 0.08, yellow_chalk);
  slate.lines({{0.08, 0.315}, {0.52, 0.31}}, yellow_chalk);
  double y = 0.43;
  for (const char* const line : {"Read page 52 to 57", "Sums 3, 4 and 8", "Bring a ruler and",
                                 "coloured pencils", "Water the plants!"}) {
    slate.write(line, {0.1, y}, 0.05, white_chalk);
    y += 0.105;
  }
  return std::move(slate).finished();
}

Image board_right(int height, const Seed& seed) {
  Slate slate(height, height, seed);
  slate.lines({{0.1, 0.6}, {0.92, 0.6}, {0.89, 0.58}}, white_chalk);
  slate.lines({{0.48, 0.92}, {0.48, 0.1}, {0.46, 0.13}}, white_chalk);
  std::vector<DVec2> parabola;
  std::vector<DVec2> wave;
  for (int i = 0; i <= 60; ++i) {
    const double x = -1.0 + i / 30.0;
    parabola.emplace_back(0.48 + 0.3 * x, 0.6 - 0.42 * x * x);
    wave.emplace_back(0.48 + 0.38 * x, 0.6 - 0.14 * std::sin(6.0 * x));
  }
  slate.lines(parabola, red_chalk);
  slate.lines(wave, blue_chalk);
  slate.write("y = x", {0.62, 0.2}, 0.055, red_chalk);
  slate.write("2", {0.795, 0.165}, 0.03, red_chalk);
  slate.write("y = sin x", {0.62, 0.76}, 0.05, blue_chalk);
  slate.write("x", {0.9, 0.68}, 0.04, white_chalk);
  slate.write("y", {0.42, 0.14}, 0.04, white_chalk);
  return std::move(slate).finished();
}

Image book_spines(int height, const Seed& seed) {
  constexpr std::array<DVec3, 8> covers = {
      DVec3(120, 35, 30),   DVec3(35, 60, 110), DVec3(45, 85, 55),   DVec3(190, 150, 70),
      DVec3(200, 190, 165), DVec3(60, 50, 70),  DVec3(205, 110, 45), DVec3(40, 40, 45)};
  constexpr std::array titles = {"Algebra",  "Our Birds", "Physics", "Atlas",        "Chemistry",
                                 "Old Rome", "Poems",     "Biology", "Geometry",     "Short Tales",
                                 "Grammar",  "The Sea",   "Botany",  "Music Theory", "Dictionary"};
  Canvas canvas(blank(4 * height, height, {128, 128, 128}));
  const double width = static_cast<double>(canvas.width()) / spines_in_image;
  Pcg32 random = generator(seed);
  for (int i = 0; i < spines_in_image; ++i) {
    const DVec3 paint = covers[random.below(covers.size())];
    const DVec3 cover = paint * (0.8 + 0.3 * random.uniform());
    const bool is_light = cover.x + cover.y + cover.z > 330.0;
    const Ink print{is_light ? DVec3(45, 35, 30) : DVec3(225, 200, 140)};
    const double left = i * width;
    canvas.fill_rectangle({left, 0}, {left + width, height}, {cover});
    for (const double v : {0.05, 0.065, 0.7, 0.8, 0.85}) {
      canvas.fill_rectangle({left, v * height}, {left + width, (v + 0.006) * height}, print);
    }
    canvas.write(titles[random.below(titles.size())], {left + 0.32 * width, 0.12 * height},
                 {.pen = {print, 0.05 * width}, .height = 0.4 * width, .along = {0.0, 1.0}});
    canvas.fill_circle({left + 0.5 * width, 0.75 * height}, 0.16 * width, print);
  }
  return std::move(canvas).finished();
}

Image written_page(int height, const Seed& seed) {
  Canvas canvas(blank(3 * height / 4, height, {244, 241, 230}));
  const double h = height;
  const double w = canvas.width();
  constexpr int lines = 20;
  Pcg32 random = generator(seed);
  for (int line = 0; line < lines; ++line) {
    const double y = h * (0.1 + 0.043 * line);
    canvas.draw_lines({{0.0, y}, {w, y}}, {{{150, 180, 215}}, 0.0016 * h});
    if (line > 0 && line < lines - 3) {
      canvas.write(sentence(random, line % 5 == 4 ? 18 : 34), {0.17 * w, y - 0.004 * h},
                   {.pen = {{{35, 45, 125}}, 0.0035 * h}, .height = 0.021 * h, .slant = 0.2});
    }
  }
  canvas.draw_lines({{0.14 * w, 0.0}, {0.14 * w, h}}, {{{215, 130, 130}}, 0.002 * h});
  canvas.write("My day", {0.3 * w, 0.09 * h},
               {.pen = {{{150, 30, 35}}, 0.005 * h}, .height = 0.035 * h});
  return std::move(canvas).finished();
}

Image notices(int height, const Seed& seed) {
  constexpr std::array<const char*, 8> titles = {"Timetable", "Trip",    "Rules", "Choir",
                                                 "Birthdays", "Week 20", "Chess", "Lost!"};
  constexpr std::array<DVec3, 8> papers = {
      DVec3(240, 238, 228), DVec3(240, 225, 140), DVec3(235, 235, 235), DVec3(170, 215, 235),
      DVec3(245, 190, 190), DVec3(238, 236, 226), DVec3(190, 225, 170), DVec3(240, 240, 235)};
  return sheets(height, [&](Canvas& canvas, const DVec2& corner, const DVec2& size, int i) {
    canvas.fill_rectangle(corner, corner + size, {papers[i]});
    canvas.write(titles[i], corner + size * DVec2(0.12, 0.17),
                 {.pen = {{{160, 35, 30}}, 0.016 * size.x}, .height = 0.08 * size.y});
    if (i % 5 == 0) {
      draw_timetable(canvas, corner, size);
    } else {
      write_paragraphs(canvas, corner, size, mix(seed, static_cast<std::uint32_t>(i)));
    }
  });
}

Image drawings(int height, const Seed& seed) {
  constexpr std::array<DVec3, 4> crayons = {DVec3(60, 90, 190), DVec3(200, 70, 60),
                                            DVec3(225, 160, 50), DVec3(130, 70, 150)};
  return sheets(height, [&](Canvas& canvas, const DVec2& corner, const DVec2& size, int i) {
    Pcg32 random = generator(mix(seed, static_cast<std::uint32_t>(i)));
    const auto at = [&](double x, double y) { return corner + size * DVec2(x, y); };
    canvas.fill_rectangle(at(0.03, 0.02), at(0.97, 0.4), {{165, 205, 235}, 0.7, 0.8});
    canvas.fill_rectangle(at(0.03, 0.74), at(0.97, 0.98), {{105, 170, 80}, 0.85, 0.6});
    draw_sun(canvas, at(0.2 + 0.6 * random.uniform(), 0.16), 0.09 * size.x);
    const double house = 0.12 + 0.3 * random.uniform();
    draw_house(canvas, at(house, 0.8), (0.28 + 0.1 * random.uniform()) * size.x,
               crayons[i % crayons.size()]);
    draw_tree(canvas, at(0.8, 0.82), (0.3 + 0.15 * random.uniform()) * size.y);
    for (int person = 0; person < 2; ++person) {
      const double place = 0.4 + 0.22 * person + 0.1 * random.uniform();
      const double tall = (0.18 + 0.1 * random.uniform()) * size.y;
      draw_person(canvas, at(place, 0.93), tall, crayons[random.below(crayons.size())]);
    }
  });
}

Image alphabet_strip(int height) {
  Canvas canvas(blank(16 * height, height, {240, 234, 214}));
  const double step = canvas.width() / 26.5;
  for (int i = 0; i < 26; ++i) {
    const double left = (i + 0.35) * step;
    const std::string pair = {static_cast<char>('A' + i), static_cast<char>('a' + i)};
    const bool is_vowel = std::string_view("AEIOU").find(pair[0]) != std::string_view::npos;
    const DVec3 color = is_vowel ? DVec3(170, 40, 35) : DVec3(35, 50, 110);
    canvas.write(pair, {left, 0.7 * height},
                 {.pen = {{color}, 0.05 * height}, .height = 0.42 * height});
  }
  const Pen rule{{{190, 180, 150}}, 0.02 * height};
  for (const double v : {0.28, 0.7}) {
    canvas.draw_lines({{0.0, v * height}, {static_cast<double>(canvas.width()), v * height}}, rule);
  }
  return std::move(canvas).finished();
}

Image facade(int size, const Seed& seed) {
  Canvas canvas(masonry(size,
                        {.courses = 48,
                         .stones = 20,
                         .joint = 0.12,
                         .variation = 0.25,
                         .stone = {0.42F, 0.2F, 0.13F},
                         .mortar = {0.45F, 0.42F, 0.38F}},
                        seed));
  const double s = size;
  const auto fill = [&](double u0, double v0, double u1, double v1, const DVec3& color) {
    canvas.fill_rectangle(s * DVec2(u0, v0), s * DVec2(u1, v1), {color});
  };
  fill(0.0, 0.94, 1.0, 0.99, {196, 188, 170});
  for (const double left : {0.12, 0.62}) {
    fill(left - 0.03, 0.17, left + 0.29, 0.8, {214, 208, 192});
    fill(left - 0.04, 0.78, left + 0.3, 0.82, {176, 170, 156});
    fill(left, 0.2, left + 0.26, 0.78, {228, 228, 222});
    for (const double x : {0.015, 0.14}) {
      for (const double y : {0.22, 0.42}) {
        fill(left + x, y, left + x + 0.105, y < 0.3 ? 0.39 : 0.765, {62, 76, 88});
      }
      fill(left + x, 0.42, left + x + 0.05, 0.7, {118, 122, 118});
    }
  }
  return std::move(canvas).finished();
}

}  // namespace foveola::scenes::school
