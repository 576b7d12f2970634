// What a protocol means, as plain aligned text.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// What a protocol means; sources are its scenes as they were found.
std::string protocol_table(const Protocol& protocol, const std::vector<SceneSource>& sources);

}  // namespace foveola::study
