// What textures are painted with: a canvas, noise, and soft-edged plane figures.
#pragma once

#include <cstdint>
#include <functional>

#include "scenes/modelling/model.h"

namespace foveola::scenes::paint {

/// The linear colour at (u, v) in (0, 1) from the top left. Called by several threads at once.
using ColorFunction = std::function<DVec3(double u, double v)>;

/// An opaque image of the colours.
Image painted(int width, int height, const ColorFunction& color);

struct Texel {
  DVec3 color{0.0};  ///< linear
  double alpha = 1.0;
};
using TexelFunction = std::function<Texel(double u, double v)>;

/// The same for images that are transparent in places.
Image cut_out(int width, int height, const TexelFunction& texel);

double smooth_step(double low, double high, double x);
DVec3 blend(const DVec3& a, const DVec3& b, double t);

/// A number in [0, 1) for the cell (x, y).
double cell_value(int x, int y, const Seed& seed);

/// Smooth noise in [0, 1] for x and y from 0, with one value at each integer point, repeating after
/// the periods (value noise, Perlin 1985 with a smoothed lattice).
double noise(double x, double y, int period_x, int period_y, const Seed& seed);

/// Four octaves of noise in [0, 1] that repeats over the unit square, the coarsest with `period`
/// cells along u and v.
double cloud(double u, double v, int period, const Seed& seed);
/// The same with other cells along u than along v.
double cloud(double u, double v, int period_u, int period_v, const Seed& seed);

/// How far x is from the nearest integer, in [0, 0.5].
double distance_to_integer(double x);

/// 1 where `distance` to an outline is negative (inside), 0 outside, soft over +-`edge`.
double inside(double distance, double edge);
/// 1 within half of `width` around an outline, 0 away from it, soft over +-`edge`.
double stroke(double distance, double width, double edge);

double distance_to_segment(const DVec2& p, const DVec2& a, const DVec2& b);

/// Distances to the outlines of figures about the origin, negative inside.
double to_circle(const DVec2& p, double radius);
double to_rectangle(const DVec2& p, const DVec2& half_size);
/// `lobes` circles whose middles lie at `offset` from the origin, the first one upwards.
double to_foil(const DVec2& p, int lobes, double offset, double radius);
/// The line from a to b as a stadium of the given radii at its ends.
double to_limb(const DVec2& p, const DVec2& a, const DVec2& b, double radius_a, double radius_b);

/// p turned into the sector of its kind: of `count` equal ones about the origin, the one upwards.
DVec2 in_sector(const DVec2& p, int count);
/// The number of that sector, in [0, count).
int sector_of(const DVec2& p, int count);

}  // namespace foveola::scenes::paint
