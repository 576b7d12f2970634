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
  int width = 0;  ///< pixels
  int height = 0;
  std::shared_ptr<const Cells> cells;
  CellPixels pixels;
  bool with_contrast = false;  ///< of an outline
};

/// Where samples go while a head faces `object` (unit length, world) and the eye looks at its
/// middle.
Aim aim_at(const Vec3& object, const DisplaySettings& display);

/// What is judged of an object, on the display of a head that faces it: pixel for pixel, since how
/// much resampling averages is a matter of how the film's pixels lie between the display's.
JudgedView view_of_outline(const Vision& vision, const OfferedObject& object,
                           const DisplaySettings& display);
JudgedView view_of_material(const Vision& vision, const OfferedObject& object,
                            const DisplaySettings& display);

/// Of each patch of the view's cells all around, in their order, some cells in its middle, which
/// stand for it; in views just large enough, with pixels as large as those of the display's middle.
std::vector<JudgedView> views_around(const Vision& vision, const DisplaySettings& display);

}  // namespace foveola::study
