// What a protocol may say and hardly means: worth a warning before anybody takes part.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// With fewer scenes, an interval for others like them covers less than its 95 %: 92 % with three,
/// 87 % with two (data/golden/README.md).
inline constexpr std::size_t min_random_scenes = 5;

/// Warnings, each as "FILE:LINE:COLUMN: WHAT; WHAT TO DO", of methods that choose the same samples
/// with the same settings, of hybrids whose weights do not add up to 1, of a scene under two names
/// or without an exposure, of few scenes for a plan that takes them for random, and of screens
/// whose words stay English. `scenes` are the protocol's, in its order.
std::vector<std::string> cautions(const Protocol& protocol, const std::vector<SceneSource>& scenes);

}  // namespace foveola::study
