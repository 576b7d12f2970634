// Which of a scene's objects is about to be chosen: the one that the view is turned to.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/window/drawing/view_overlays.h"
#include "study/participant/participant.h"

namespace foveola::study {

/// The index of the object that is nearest to the view's middle. offered: at least one. ahead: unit
/// length, world.
std::size_t object_ahead(const std::vector<OfferedObject>& offered, const Vec3& ahead);

/// A ring for each, the highlighted one's on top.
std::vector<OfferRing> rings_of(const std::vector<OfferedObject>& offered, std::size_t highlighted);

/// The ring of the object that is already chosen.
OfferRing ring_of(const OfferedObject& chosen);

}  // namespace foveola::study
