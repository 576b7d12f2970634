// Proposes objects that participants of a study might choose, from the camera's view.
#pragma once

#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/progressive/loaded_scene.h"

namespace foveola {

struct ProposedObject {
  /// Named as in the file. Its position, in the file's world in metres, is a point of its surface
  /// visible from the camera, in the centre of its visible part.
  ObjectOfInterest object;
  /// Share of unoccluded rays among the camera's rays that would hit the object if it stood alone;
  /// in (0, 1].
  double visible_share = 0.0;
  double distance_m = 0.0;
};

/// Criteria for worthwhile objects.
struct ProposalRule {
  double least_radius_deg = 1.0;
  double largest_radius_deg = 20.0;
  double largest_elevation_deg = 60.0;  ///< above and below the horizon
  double least_visible_share = 0.5;
  /// Minimum share of the object's circle that its visible part fills: excludes cables and frames.
  double least_fill = 0.15;
  std::size_t max_objects = 12;
};

/// Proposes objects, the best first. An object consists of all meshes of one name in the file, or
/// of one unnamed mesh; emitters are excluded. Objects within `rule` are ranked by the product of
/// visible share, filled share of the circle, and radius up to 4 degrees. An object whose circle
/// overlaps that of a better one is left out, since a gaze could not distinguish them. 2^18 rays
/// are traced in directions that lie evenly on the sphere, each through up to 64 surfaces.
std::vector<ProposedObject> propose_objects(const LoadedScene& loaded, const Workers& workers,
                                            const ProposalRule& rule = {});

}  // namespace foveola
