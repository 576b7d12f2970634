// Selects the object of a scene that the view is turned to.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/window/drawing/view_overlays.h"
#include "study/participant/participant.h"

namespace foveola::study {

/// Returns the index of the object nearest to the centre of the view. offered: at least one. ahead:
/// unit length, world.
std::size_t object_ahead(const std::vector<OfferedObject>& offered, const Vec3& ahead);

/// Returns a ring for each object, that of the highlighted one on top.
std::vector<OfferRing> rings_of(const std::vector<OfferedObject>& offered, std::size_t highlighted);

OfferRing ring_of(const OfferedObject& chosen);

}  // namespace foveola::study
