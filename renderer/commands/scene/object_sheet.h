// Renders a picture of each object that a scene offers, for choosing by eye.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/image/image.h"
#include "renderer/progressive/loaded_scene.h"

namespace foveola {

/// The objects of `source` from the scene's camera, in rows of four. Each is centred in a picture
/// twice as wide as its circle (at least 4 degrees), with its number, from 1, and its name below.
/// Linear, exposed by `exposure_stops`. Needs at least one object. Throws Error if stopped.
RgbImage object_sheet(const LoadedScene& loaded, const SceneSource& source, double exposure_stops,
                      const Workers& workers, const std::stop_token& stop);

}  // namespace foveola
