// Objects of a scene that participants of a study might choose, proposed from what the camera sees.
#pragma once

#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/progressive/loaded_scene.h"

namespace foveola {

struct ProposedObject {
  /// Called as in the file. Its position, in the file's world in metres, is a point of its surface
  /// that is seen from the camera, in the middle of what is seen of it.
  ObjectOfInterest object;
  /// Of the rays from the camera that would meet the object if nothing stood before it, the share
  /// that meets it first; in (0, 1].
  double visible_share = 0.0;
  double distance_m = 0.0;
};

/// What makes an object worth choosing.
struct ProposalRule {
  double least_radius_deg = 1.0;
  double largest_radius_deg = 20.0;
  double largest_elevation_deg = 60.0;  ///< above and below the horizon
  double least_visible_share = 0.5;
  /// Of the circle of its radius, the least share that what is seen of it fills: neither cables nor
  /// frames.
  double least_fill = 0.15;
  std::size_t max_objects = 12;
};

/// Proposes objects, the best first. An object is what bears one name in the file, or if it has no
/// name one mesh; what shines by itself is none. Of those that keep to `rule`, the best have the
/// largest product of visible share, filled share of the circle, and radius as far as 4 degrees. An
/// object whose circle overlaps that of a better one is left out: a gaze could not tell them apart.
/// 2^18 rays are traced in directions that lie evenly on the sphere, each through up to 64
/// surfaces.
std::vector<ProposedObject> propose_objects(const LoadedScene& loaded, const Workers& workers,
                                            const ProposalRule& rule = {});

}  // namespace foveola
