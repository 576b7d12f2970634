// A protocol with given numbers of scenes and methods, named by letters.
#pragma once

#include "study/protocol/protocol.h"

namespace foveola::test {

/// Scenes a, b, ...; methods x, y, z and no more; the phase of trials.
inline study::Protocol small_protocol(int scenes, int methods, study::Order scene_order,
                                      study::Order method_order) {
  study::Protocol protocol;
  for (int i = 0; i < scenes; ++i) {
    protocol.scenes.push_back({.name = std::string(1, static_cast<char>('a' + i))});
  }
  for (int i = 0; i < methods; ++i) {
    protocol.methods.emplace_back(1, static_cast<char>('x' + i));
  }
  protocol.scene_order = scene_order;
  protocol.method_order = method_order;
  protocol.phases = {{study::PhaseEntry::Kind::trials}};
  return protocol;
}

}  // namespace foveola::test
