#include "study/design/plan.h"

#include <span>

#include "renderer/base/random.h"

namespace foveola::study {

Plan random_plan(const Protocol& protocol, std::uint64_t seed, int participant_index) {
  Pcg32 generator(seed, static_cast<std::uint64_t>(participant_index));
  std::vector<SceneEntry> scenes = protocol.scenes;
  shuffle(std::span(scenes), generator);
  Plan plan;
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    std::vector<std::string> methods = protocol.methods;
    shuffle(std::span(methods), generator);
    for (std::size_t method = 0; method < methods.size(); ++method) {
      plan.push_back({.scene = scenes[scene].name,
                      .method = methods[method],
                      .scene_position = static_cast<int>(scene),
                      .method_position = static_cast<int>(method)});
    }
  }
  return plan;
}

}  // namespace foveola::study
