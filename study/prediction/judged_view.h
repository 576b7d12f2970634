// What a pilot looks at: views just large enough for the cells that are judged, with pixels as
// large as those of the display's middle.
#pragma once

#include <memory>
#include <vector>

#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"
#include "study/participant/cells.h"
#include "study/participant/participant.h"
#include "study/participant/sighting.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

struct JudgedView {
  Viewport viewport;
  int side = 0;  ///< pixels, of a square
  std::shared_ptr<const Cells> cells;
  CellPixels pixels;
  bool with_contrast = false;  ///< of an outline
};

/// Where samples go while a head faces `object` (unit length, world) and the eye looks at its
/// middle.
Aim aim_at(const Vec3& object, const DisplaySettings& display);

/// The angle of a pixel in the middle of the display, radians.
double display_pixel_rad(const DisplaySettings& display);

/// What is judged of an object, seen by a head that faces it.
JudgedView view_of_outline(const Vision& vision, const OfferedObject& object, double pixel_rad);
JudgedView view_of_material(const Vision& vision, const OfferedObject& object, double pixel_rad);

/// Of each patch of the view's cells all around, in their order, some cells in its middle, which
/// stand for it.
std::vector<JudgedView> views_around(const Vision& vision, double pixel_rad);

}  // namespace foveola::study
