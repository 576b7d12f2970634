// The point whose incoming light is sampled, as far as drawing lights needs to know it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

struct ShadingPoint {
  Vec3 position{0.0F};
  Vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit length; of the geometry, not of its shading
  bool transmits = true;          ///< light may arrive from both sides, not from the normal's alone
  std::uint32_t region = 0;       ///< see Lights::region_of()
};

/// ShadingPoints that light arrives at from their normal's side only, one a lane.
struct ShadingPoints {
  Vec3Lanes position;
  Vec3Lanes normal;
  UintLanes region{};

  ShadingPoint at(std::size_t lane) const {
    return {.position = position.at(lane),
            .normal = normal.at(lane),
            .transmits = false,
            .region = region[lane]};
  }
};

}  // namespace foveola
