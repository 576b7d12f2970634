// Pearson's chi-squared test of directions against a stated density over the sphere.
#pragma once

#include <functional>
#include <numbers>
#include <span>

#include "renderer/base/vec.h"

namespace foveola::test {

/// The probability that samples which follow `density_per_sr` differ from it by as much as
/// `directions` do. The sphere is cut into equirect cells around `pole`, so that cells are small
/// where a density peaks there; the expected counts come from numerical quadrature of the density.
/// Cells that expect fewer than five samples are pooled. With a reach below pi the cells divide
/// what lies so near to the pole, and all beyond, of which a density that integrates to 1 has the
/// rest, is a single one.
double chi_squared_p_value(std::span<const Vec3> directions,
                           const std::function<double(const Vec3&)>& density_per_sr,
                           const Vec3& pole, double reach_rad = std::numbers::pi);

/// The integral of `density_per_sr` over the sphere by the midpoint rule, dense around `pole`.
double integral_over_sphere(const std::function<double(const Vec3&)>& density_per_sr,
                            const Vec3& pole);

}  // namespace foveola::test
