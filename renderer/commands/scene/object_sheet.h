// A picture of each object that a scene offers, for choosing by eye.
#pragma once

#include <stop_token>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"
#include "renderer/image/image.h"
#include "renderer/progressive/loaded_scene.h"

namespace foveola {

/// The objects of `source` as they look from the scene's camera, in rows of four, each in the
/// middle of a picture twice as wide as its circle (at least 4 degrees) and with its number, from
/// 1, and its name below it. Linear, exposed by `exposure_stops`. There is at least one object.
/// Throws Error if stopped.
RgbImage object_sheet(const LoadedScene& loaded, const SceneSource& source, double exposure_stops,
                      const Workers& workers, const std::stop_token& stop);

}  // namespace foveola
