// What a protocol may say and hardly means: worth a warning before anybody takes part.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Warnings, each as "FILE:LINE:COLUMN: WHAT; WHAT TO DO", of methods that choose the same samples
/// with the same settings, of a scene under two names, and of screens whose words stay English.
/// `scenes` are the protocol's, in its order.
std::vector<std::string> cautions(const Protocol& protocol, const std::vector<SceneSource>& scenes);

}  // namespace foveola::study
