// The church's glass, with the stone and iron that hold it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "scenes/church/parts.h"
#include "scenes/modelling/architecture.h"

namespace foveola::scenes::church {
namespace {

/// How far panes reach into the wall around their opening.
constexpr double rebate = 0.04;

constexpr double daylight_behind_glass = 0.3;

Shape placed(const Shape& shape, const WindowPlace& place) {
  return moved(turned(shape, place.turn_deg), place.sill);
}

double window_height(const WindowPlace& place) { return place.jamb + 0.5 * place.width; }

/// The whole image over the opening's bounding rectangle; its corners lie hidden in the wall.
Shape pane(const WindowPlace& place) {
  const double half = 0.5 * place.width + rebate;
  return placed(picture({-half, -rebate, 0.0}, {2.0 * half, 0.0, 0.0},
                        {0.0, window_height(place) + 2.0 * rebate, 0.0}),
                place);
}

/// A moulding around the opening on the inside, and a sill.
Shape surround(const WindowPlace& place) {
  const double radius = 0.5 * place.width;
  Shape shape;
  const double face = 0.5 * wall;
  const auto edge = round_arch_path(radius + 0.06, place.jamb + 0.03, 10);
  append(shape, moved(swept(edge, rib_profile(0.12, 0.1), {0, 0, 1}), {0.0, place.jamb, face}));
  append(shape, moved(box(DVec3(place.width + 0.5, 0.1, 0.16)), {0.0, -0.06, face + 0.02}));
  return placed(shape, place);
}

/// Bars across the glass on the inside.
Shape bars(const WindowPlace& place) {
  const double half = 0.5 * place.width + rebate;
  Shape shape;
  const int count = static_cast<int>(place.jamb / 0.55);
  for (int i = 1; i <= count; ++i) {
    const double y = place.jamb * i / count;
    append(shape, moved(box(DVec3(2.0 * half, 0.025, 0.02)), {0.0, y, 0.03}));
  }
  append(shape, moved(box(DVec3(0.02, window_height(place), 0.02)),
                      {0.0, 0.5 * window_height(place), 0.045}));
  return placed(shape, place);
}

/// What shines in through the opening: the sky, brought close behind the glass, where light samples
/// meet nothing but the glass on their way into the room.
Shape daylight(const WindowPlace& place) {
  constexpr int arch_rows = 6;
  const double radius = 0.5 * place.width + 0.01;
  const Shape sheet = patch(1, arch_rows + 1, [&](double u, double v) {
    const double row = v * (arch_rows + 1);
    const double angle = 0.5 * std::numbers::pi * std::max(0.0, row - 1.0) / arch_rows;
    const double height = row < 0.5 ? -0.01 : place.jamb + radius * std::sin(angle);
    return DVec3((2.0 * u - 1.0) * radius * std::cos(angle), height, -daylight_behind_glass);
  });
  return placed(sheet, place);
}

/// The light behind windows on either side of the church.
struct Skies {
  int north = 0;
  int south = 0;
};

void add_group(Model& model, const Materials& m, const std::string& name,
               const std::vector<WindowPlace>& places, const std::vector<int>& glasses,
               const Skies& skies) {
  std::vector<Part> panes;
  for (const int glass : glasses) {
    panes.push_back({glass, {}});
  }
  Shape stone;
  Shape iron;
  Shape southern_light;
  Shape northern_light;
  for (std::size_t i = 0; i < places.size(); ++i) {
    append(places[i].sill.z > 0.5 ? southern_light : northern_light, daylight(places[i]));
    append(panes[i % panes.size()].shape, pane(places[i]));
    append(stone, surround(places[i]));
    append(iron, bars(places[i]));
  }
  add_object(model, name, panes);
  add_object(model, name + ", frames", {{m.limestone, stone}, {m.iron, iron}});
  add_object(model, name + ", daylight",
             {{skies.south, southern_light}, {skies.north, northern_light}});
}

/// Twelve spokes between an inner and an outer ring, with a small ring at each end.
void add_rose(Model& model, const Materials& m) {
  const auto ring = [](double radius, double tube_radius, int segments) {
    return turned(torus(radius, tube_radius, segments, 5), 90.0, {1, 0, 0});
  };
  Shape tracery = ring(rose_radius, 0.09, 40);
  append(tracery, ring(0.3 * rose_radius, 0.05, 32));
  const Shape spoke =
      moved(box(DVec3(0.06, 0.42 * rose_radius, 0.1)), {0.0, 0.51 * rose_radius, 0});
  const Shape eye = moved(ring(0.13 * rose_radius, 0.035, 12), {0.0, 0.86 * rose_radius, 0.0});
  constexpr int petals = 12;
  for (int i = 0; i < petals; ++i) {
    append(tracery, turned(spoke, 360.0 * (i + 0.5) / petals, {0, 0, 1}));
    append(tracery, turned(eye, 360.0 * (i + 0.5) / petals, {0, 0, 1}));
  }
  Shape mouldings = moved(ring(rose_radius, 0.07, 40), {0.0, 0.0, 0.5 * wall});
  append(mouldings, moved(ring(rose_radius + 0.2, 0.06, 40), {0.0, 0.0, 0.5 * wall}));
  append(tracery, mouldings);
  const double half = rose_radius + rebate;
  const Shape glass = picture({-half, -half, 0.0}, {2.0 * half, 0, 0}, {0, 2.0 * half, 0});
  const auto put = [](const Shape& shape) {
    return moved(turned(shape, 90.0), {-half_length - 0.5 * wall, rose_height, 0.0});
  };
  add_object(model, "Rose window", {{m.rose_glass, put(glass)}, {m.limestone, put(tracery)}});
  const Shape sheet = lathe({{rose_radius + 0.01, 0.0}, {0.0, 0.0}}, 32);
  add_object(model, "Rose window, daylight",
             {{m.northern_sky,
               put(moved(turned(sheet, 90.0, {1, 0, 0}), {0.0, 0.0, -daylight_behind_glass}))}});
}

}  // namespace

void add_windows(Model& model, const Materials& m) {
  add_group(model, m, "Aisle windows", aisle_windows(),
            {m.blue_glass, m.white_glass, m.green_glass}, {m.shaded_sky, m.shaded_sky});
  add_group(model, m, "Upper windows", clerestory_windows(), {m.grisaille},
            {m.northern_sky, m.southern_sky});
  add_group(model, m, "Apse windows", apse_windows(), {m.blue_glass, m.green_glass},
            {m.shaded_sky, m.shaded_sky});
  add_rose(model, m);
}

}  // namespace foveola::scenes::church
