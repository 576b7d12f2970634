// The smooth skin that every panel and window of the car lies on.
//
// The car faces +X, stands on y = 0 and has +Z on its right. Its skin is where a function like a
// distance vanishes, so that panels, whatever view they are drawn in, meet without a step.
#pragma once

#include "scenes/modelling/shapes.h"

namespace foveola::scenes::car {

constexpr double wheel_radius = 0.33;
constexpr double wheel_arch_radius = 0.385;
constexpr double front_axle = 1.36;
constexpr double rear_axle = -1.32;
constexpr double wheel_middle_z = 0.775;
constexpr double tyre_half_width = 0.105;

/// Roughly the distance from the skin: negative inside.
double distance_to_skin(const DVec3& p);

/// Unit length, outwards.
DVec3 skin_normal(const DVec3& p);

/// The skin's point near `p`, or the one `depth` below it.
DVec3 on_skin(DVec3 p, double depth = 0.0);

/// Where a straight view first meets the skin: from +Z, from above, and towards the
/// vertical axis at `axis_x` from the direction that `angle_deg` turns from +X towards +Z.
DVec3 seen_from_side(double x, double y);
DVec3 seen_from_above(double x, double z);
DVec3 seen_from_around(double axis_x, double angle_deg, double y);

}  // namespace foveola::scenes::car
