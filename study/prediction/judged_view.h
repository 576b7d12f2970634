// Makes the views in which a pilot is judged: just large enough for the judged cells, with pixels
// as large as those at the display's centre.
#pragma once

#include <string>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "study/participant/observer/cells.h"
#include "study/participant/observer/evidence.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

struct JudgedCells {
  Cells cells;
  CellPixels pixels;
  bool with_contrast = false;  ///< whether the contrast at an outline is judged
};

struct JudgedView {
  Viewport viewport;
  int width = 0;  ///< pixels
  int height = 0;
  std::vector<JudgedCells> judged;  ///< the cells on each scale
};

struct Cone {
  Vec3 middle{0.0F};  ///< unit length, world
  double radius_rad = 0.0;
};

/// The name of a view sampler: uniform over a rectangle of the image that the cone lies in.
std::string crop_sampler(const Cone& cone);

/// Returns the aim while a head faces `object` (unit length, world) and the eye looks at its
/// centre.
Aim aim_at(const Vec3& object, const DisplaySettings& display);

/// Returns the view of an object, its outline's cells first, then its material's on each scale, on
/// the display of a head that faces it. It has the display's pixels exactly, since averaging by
/// resampling depends on the film's pixels between the display's.
JudgedView view_of_object(const Vision& vision, const OfferedObject& object,
                          const DisplaySettings& display);

/// Returns the centres of patches of about view_patch_deg that cover all directions: rows of equal
/// elevation, each divided into equal azimuths. highest_deg: maximum elevation of the centres above
/// and below the horizon.
std::vector<Vec3> surround_places(const Vision& vision, double highest_deg);

/// Returns, for each of these patches, in their order, a view of a few representative cells at its
/// centre on each scale. Views are just large enough, with pixels as large as those at the
/// display's centre.
std::vector<JudgedView> surround_views(const Vision& vision, const DisplaySettings& display,
                                       const std::vector<Vec3>& places);

}  // namespace foveola::study
