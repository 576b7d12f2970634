// Warns of valid protocols that are probably not meant so.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Minimum number of random scenes: with fewer, the interval for other scenes undercovers: 92 %
/// with three, 87 % with two (data/golden/README.md).
inline constexpr std::size_t min_random_scenes = 5;

/// Returns warnings, each as "FILE:LINE:COLUMN: FAULT; REMEDY". They are about methods that choose
/// the same samples with the same settings, hybrids whose weights do not add up to 1, a scene under
/// two names or without an exposure, few scenes for a plan with random ones, and screens whose
/// texts stay English. `scenes` are the protocol's, in its order.
std::vector<std::string> cautions(const Protocol& protocol, const std::vector<SceneSource>& scenes);

}  // namespace foveola::study
