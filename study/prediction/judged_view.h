// The views that a pilot is judged in: just large enough for the cells that are judged, with pixels
// as large as those of the display's middle.
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

/// Cells and where their pixels are.
struct JudgedCells {
  Cells cells;
  CellPixels pixels;
  bool with_contrast = false;  ///< whether the contrast at an outline is judged
};

struct JudgedView {
  Viewport viewport;
  int width = 0;  ///< pixels
  int height = 0;
  std::vector<JudgedCells> judged;  ///< the judged cells on each scale
};

/// A cone of directions.
struct Cone {
  Vec3 middle{0.0F};  ///< unit length, world
  double radius_rad = 0.0;
};

/// The name of a view sampler: uniform over a rectangle of the image that the cone lies in.
std::string crop_sampler(const Cone& cone);

/// Where samples go while a head faces `object` (unit length, world) and the eye looks at its
/// middle.
Aim aim_at(const Vec3& object, const DisplaySettings& display);

/// What is judged of an object, its outline first, then its material on each scale, on the display
/// of a head that faces it: pixel for pixel, since how much resampling averages is a matter of how
/// the film's pixels lie between the display's.
JudgedView view_of_object(const Vision& vision, const OfferedObject& object,
                          const DisplaySettings& display);

/// The middles of patches of about view_patch_deg that cover all directions: rows of equal
/// elevation, each divided into equal azimuths. highest_deg: of the middles, above the horizon or
/// below it.
std::vector<Vec3> surround_places(const Vision& vision, double highest_deg);

/// For each of these patches, in their order, some cells in its middle on each scale, which stand
/// for it; in views just large enough, with pixels as large as those of the display's middle.
std::vector<JudgedView> surround_views(const Vision& vision, const DisplaySettings& display,
                                       const std::vector<Vec3>& places);

}  // namespace foveola::study
