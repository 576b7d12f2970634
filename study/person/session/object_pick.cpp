#include "study/person/session/object_pick.h"

#include <algorithm>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

OfferRing ring_around(const OfferedObject& object, bool is_highlighted) {
  return {.direction = object.direction,
          .radius_rad = static_cast<float>(radians(object.radius_deg)),
          .is_highlighted = is_highlighted};
}

}  // namespace

std::size_t object_ahead(const std::vector<OfferedObject>& offered, const Vec3& ahead) {
  const auto angle = [&](const OfferedObject& object) {
    return angle_between(object.direction, ahead);
  };
  const auto nearest = std::min_element(
      offered.begin(), offered.end(),
      [&](const OfferedObject& a, const OfferedObject& b) { return angle(a) < angle(b); });
  return static_cast<std::size_t>(nearest - offered.begin());
}

std::vector<OfferRing> rings_of(const std::vector<OfferedObject>& offered,
                                std::size_t highlighted) {
  std::vector<OfferRing> rings;
  for (std::size_t i = 0; i < offered.size(); ++i) {
    if (i != highlighted) {
      rings.push_back(ring_around(offered[i], false));
    }
  }
  rings.push_back(ring_around(offered[highlighted], true));
  return rings;
}

OfferRing ring_of(const OfferedObject& chosen) { return ring_around(chosen, true); }

}  // namespace foveola::study
