// The objects of a scene that a participant may choose.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/vec.h"

namespace foveola::study {

/// An object, seen from the viewpoint.
struct OfferedObject {
  std::string name;
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< Unit length, world.
  double radius_deg = 4.0;            ///< Angular radius that covers it.
};

/// Returns the object of this name. Throws Error if the scene no longer offers it.
const OfferedObject& object_named(const std::vector<OfferedObject>& offered,
                                  const std::string& name);

}  // namespace foveola::study
