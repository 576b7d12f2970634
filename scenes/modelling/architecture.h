// Shapes of architecture: mouldings, arches, vaults, shafts, figures.
#pragma once

#include <vector>

#include "scenes/modelling/shapes.h"

namespace foveola::scenes {

/// `profile`, a closed counter-clockwise outline, carried along `path`. Its x lies along `side`, a
/// unit vector across the whole path; its y along cross(side, direction of the path). The ends stay
/// open: they belong inside what the moulding is fixed to.
Shape swept(const std::vector<DVec3>& path, const std::vector<DVec2>& profile, const DVec3& side);

/// A moulding's outline, `width` wide and `height` high about the origin, chamfered below.
std::vector<DVec2> rib_profile(double width, double height);

/// Points of an upright round arch about the origin, from its left foot at y = -`stilt` over the
/// crown to the right one.
std::vector<DVec3> round_arch_path(double radius, double stilt, int segments);

/// The height of a pointed arch of height 1 over s in [-1, 1].
double pointed_arch(double s);

/// One bay of a cross vault, on `middle` at its springing.
struct VaultBay {
  DVec3 middle{0.0};
  double half_x = 2.0;
  double half_z = 2.0;
  double rise = 3.0;
};
/// The point of the vault over (s, t) in [-1, 1] squared.
DVec3 on_vault(const VaultBay& bay, double s, double t);
/// Its four webs, seen from below.
Shape vault_webs(const VaultBay& bay, int columns, int rows);
/// The line on the vault from (s, t) = `from` to `to`, closer where the vault is steeper.
std::vector<DVec3> vault_line(const VaultBay& bay, const DVec2& from, const DVec2& to,
                              int segments);

/// A slim shaft with ring-shaped base and capital, standing on the origin.
Shape shaft(double radius, double height, int segments);

/// A robed figure about `height` high that stands on the origin and faces +Z.
Shape robed_figure(double height);

/// A wall of `width` by `height` about the origin with a round hole, facing +Z, and the hole's side
/// back to z = -`depth`.
Shape wall_with_round_hole(double width, double height, double radius, double depth);

}  // namespace foveola::scenes
