// Whether a scene is a room to stand in, and where in it.
#pragma once

#include <optional>

#include "renderer/progressive/standpoint.h"

namespace foveola {

/// The place in a room that choose_standpoint describes; none if the scene is no room.
std::optional<Standpoint> standpoint_in_room(const Scene& scene, const RayScene& rays,
                                             const Bounds& bounds,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
