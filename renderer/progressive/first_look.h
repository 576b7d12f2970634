// What a user is told about a scene as it is first seen: what it lacks, and where the camera stands
// if the file has none.
#pragma once

#include <string>
#include <vector>

#include "renderer/progressive/standpoint.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/ray_scene.h"

namespace foveola {

/// Lights a scene in which nothing shines evenly from all around, and more from above.
void add_studio_light(Scene& scene);

/// One line each for what a scene lacks: geometry, or light; the option that mends it is the one
/// that helps where the camera stands. has_studio_light: whether only that lights it.
std::vector<std::string> lacks_of(const Scene& scene, bool camera_is_enclosed,
                                  bool has_studio_light = false);

/// Where a file without a camera is seen from, why, and how to look from elsewhere; one more line
/// if nearly all of the picture is empty, because objects lie too far apart.
std::vector<std::string> notes_on_standpoint(const Scene& scene, const RayScene& rays,
                                             const Standpoint& standpoint,
                                             const FieldOfView& field_of_view);

}  // namespace foveola
