#include "study/stage/seeds.h"

#include <algorithm>

namespace foveola::study {
namespace {

int scene_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::ranges::find(protocol.scenes, name, &SceneEntry::name);
  return static_cast<int>(found - protocol.scenes.begin());
}

int method_index(const Protocol& protocol, const std::string& name) {
  const auto found = std::ranges::find(protocol.methods, name);
  return static_cast<int>(found - protocol.methods.begin());
}

}  // namespace

std::uint32_t trial_seed(const SessionSeed& session, SeedPurpose purpose, const Protocol& protocol,
                         const PlannedTrial& trial, int timing) {
  return derive_seed(session, purpose,
                     {scene_index(protocol, trial.scene), method_index(protocol, trial.method),
                      timing, static_cast<int>(trial.kind)});
}

}  // namespace foveola::study
