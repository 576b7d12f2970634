// Writes a scene's descriptor.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

/// Returns the text of a descriptor of `source`, a scene from a file without lights or suns of a
/// descriptor's own. read_descriptor() reads the same from it, except for rounding. Angles have
/// twelve digits, an object's radius three; the positions of a file in metres are exact. remarks: a
/// comment for each of the source's objects, or none. The image of an environment is named without
/// its folder, which must be the descriptor's. Throws Error for values that a descriptor cannot
/// have, such as a position too far away, and for files whose names it cannot contain.
std::string descriptor_text(const SceneSource& source, const std::vector<std::string>& remarks);

}  // namespace foveola::scenes
