// --environment, for the commands that make pictures.
#pragma once

#include <string>

#include "renderer/base/scene_source.h"

namespace foveola {

/// The help text of --environment.
inline constexpr const char* environment_help =
    "What surrounds the scene: a lat-long image file, r,g,b for a constant radiance, or "
    "sky:AZIMUTH,ELEVATION[,TURBIDITY] for daylight with the sun there (degrees)";

/// Gives `source` the environment that `text` names in place of its own: "r,g,b" is a constant
/// radiance, "sky:..." daylight, anything else a file, which is not read yet. What a descriptor
/// says of its own environment does not hold for another. Throws UsageError, and Error for a file
/// that does not exist.
void replace_environment(const std::string& text, SceneSource& source);

}  // namespace foveola
