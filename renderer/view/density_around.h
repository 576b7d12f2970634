// How densely a sampler samples a pixel or a patch, told by one place in it.
#pragma once

#include "renderer/view/view_sampler.h"

namespace foveola {

/// The sampler's density per steradian at `direction` (unit length, world); where it is 0 just
/// there, the largest of four places a hundredth of a degree around it. For what is larger than
/// that: fv-paper leaves out a ring of half a hundredth, and a pixel or patch whose middle lies in
/// the ring is reached all the same.
double density_around(const ViewSampler& sampler, const Vec3& direction);

}  // namespace foveola
