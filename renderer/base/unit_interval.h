// The end of the unit interval [0, 1) in which random numbers lie.
#pragma once

namespace foveola {

/// 1 - 2^-24, the largest float below 1.
inline constexpr float largest_below_one = 0x1.fffffep-1F;

}  // namespace foveola
