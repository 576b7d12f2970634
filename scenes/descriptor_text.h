// Writing a scene's descriptor.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"

namespace foveola::scenes {

/// The text of a descriptor of `source`, which comes from a file and was given no lights or suns of
/// a descriptor's own: read_descriptor() reads the same from it, but for rounding. Angles have
/// twelve digits, an object's radius three; the positions of a file in metres are the same to the
/// bit.
/// remarks: a comment for each of the source's objects, or none. The image of an environment is
/// named without its folder, which must be the descriptor's. Throws Error for what no descriptor
/// may say, such as a position too far away, and for files whose names it cannot hold.
std::string descriptor_text(const SceneSource& source, const std::vector<std::string>& remarks);

}  // namespace foveola::scenes
