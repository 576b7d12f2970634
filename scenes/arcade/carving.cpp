// Carved stone: columns with leaved capitals, and the balustrade between the upper ones.
#include "scenes/arcade/parts.h"
#include "scenes/modelling/column.h"

namespace foveola::scenes::arcade {

void add_columns(Model& model, const Materials& m) {
  const Shape lower = carved_column({.radius = 0.2, .height = lower_springing, .slab = 0.62});
  const Shape upper = carved_column({.radius = 0.16,
                                     .height = upper_springing - upper_floor,
                                     .slab = 0.62,
                                     .segments = 14,
                                     .leaf_rows = 5});
  Shape columns;
  for_each_column([&](double x, double z, double) {
    append(columns, moved(lower, {x, 0.0, z}));
    append(columns, moved(upper, {x, upper_floor, z}));
  });
  add_object(model, "Columns", {{m.limestone, with_uv_scale(columns, 0.5)}});
  Shape piers;
  for_each_corner([&](double x, double z) {
    const auto block = [&](double half, double bottom, double top) {
      append(piers, moved(rounded_box({2.0 * half, top - bottom, 2.0 * half}, 0.015, 1),
                          {x, 0.5 * (bottom + top), z}));
    };
    block(pier_half + 0.05, -0.02, 0.22);
    block(pier_half, 0.2, lower_springing - 0.1);
    block(pier_half + 0.04, lower_springing - 0.12, lower_springing);
    block(pier_half, lower_springing - 0.01, upper_floor + 0.02);
    block(pier_half + 0.04, upper_floor, upper_floor + 0.2);
    block(pier_half, upper_floor + 0.18, upper_springing - 0.1);
    block(pier_half + 0.04, upper_springing - 0.12, upper_springing);
    block(pier_half, upper_springing - 0.01, upper_ceiling + 0.02);
  });
  add_object(model, "Corner piers", {{m.limestone, with_uv_scale(piers, 0.5)}});
}

void add_balustrade(Model& model, const Materials& m) {
  constexpr double height = 0.8;
  constexpr double rail = 0.1;
  constexpr double plinth = 0.1;
  // One post's swellings and necks, as fractions of its height.
  const std::vector<DVec2> outline = {{0.06, 0.07},  {0.035, 0.14}, {0.044, 0.2},  {0.064, 0.33},
                                      {0.062, 0.43}, {0.044, 0.57}, {0.031, 0.76}, {0.05, 0.82},
                                      {0.05, 0.85},  {0.034, 0.88}, {0.058, 0.93}};
  Shape post = lathe(outline, 10);
  append(post, moved(box(DVec3(0.13, 0.07, 0.13)), {0.0, 0.035, 0.0}));
  append(post, moved(box(DVec3(0.13, 0.07, 0.13)), {0.0, 0.965, 0.0}));
  const double post_height = height - plinth;
  post = scaled(post, {1.0, post_height, 1.0});
  Shape one;
  for (int i = 0; i < 8; ++i) {
    append(one, moved(post, {(i - 3.5) * 0.31, plinth, 0.0}));
  }
  append(one, moved(rounded_box({2.66, plinth + 0.02, 0.2}, 0.012, 1), {0.0, 0.5 * plinth, 0.0}));
  append(one,
         moved(rounded_box({2.7, rail, 0.24}, 0.03, 1), {0.0, height + 0.5 * rail - 0.002, 0.0}));
  add_object(model, "Balustrade",
             {{m.limestone, with_uv_scale(moved(in_each_bay(one), {0.0, upper_walk, 0.0}), 0.5)}});
}

}  // namespace foveola::scenes::arcade
