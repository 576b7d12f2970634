// One seed for a session, and from it an independent one for everything drawn at random.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "renderer/base/random.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// What a seed is for; keeps the streams apart.
enum class SeedPurpose : std::uint32_t {
  participant = 1,  ///< who a simulated participant is
  tracker = 2,      ///< the noise of a simulated tracker
  rendering = 3,    ///< a trial's sample points and light paths
  conduct = 4,      ///< what a simulated participant does, timing after timing
  waiting = 5,      ///< how long nothing appears to react to
  picture = 6,      ///< which picture of its object a predicted trial sees
};

/// What the record keeps of a session's randomness.
struct SessionSeed {
  std::uint64_t seed = 0;
  int design_row = 0;
};

/// The seed for `purpose` at `place`, such as {step, how many times before}.
inline std::uint32_t derive_seed(const SessionSeed& session, SeedPurpose purpose,
                                 std::initializer_list<int> place) {
  std::uint32_t seed = mix(static_cast<std::uint32_t>(session.seed));
  seed = mix(seed, static_cast<std::uint32_t>(session.seed >> 32));
  seed = mix(seed, static_cast<std::uint32_t>(purpose));
  seed = mix(seed, static_cast<std::uint32_t>(session.design_row));
  for (const int index : place) {
    seed = mix(seed, static_cast<std::uint32_t>(index));
  }
  return seed;
}

/// The seed for `purpose` in one timing of a trial. Attempts that a pause or a crash ended have
/// that of the attempt in their place, so that a session's results do not depend on where it broke
/// off.
inline std::uint32_t trial_seed(const SessionSeed& session, SeedPurpose purpose,
                                const Protocol& protocol, const PlannedTrial& trial, int timing) {
  return derive_seed(session, purpose,
                     {static_cast<int>(scene_index(protocol, trial.scene)),
                      static_cast<int>(method_index(protocol, trial.method)), timing,
                      static_cast<int>(trial.kind)});
}

/// The seed of the picture that a predicted trial sees, whenever it is timed.
inline std::uint32_t picture_seed(const SessionSeed& session, const Protocol& protocol,
                                  const PlannedTrial& trial) {
  return trial_seed(session, SeedPurpose::picture, protocol, trial, 0);
}

/// The seed for `purpose` the next time that the step of the agenda is tried in which `state` is.
inline std::uint32_t step_seed(const SessionSeed& session, SeedPurpose purpose,
                               const SessionState& state) {
  return derive_seed(session, purpose,
                     {static_cast<int>(state.step), state.validations_left, state.presses_left});
}

/// The seed of a trial's sample points and light paths: with the recorded frames it makes the same
/// film again.
inline std::uint32_t rendering_seed(std::uint64_t session_seed, int design_row,
                                    const Protocol& protocol, const PlannedTrial& trial,
                                    int timing) {
  return trial_seed({.seed = session_seed, .design_row = design_row}, SeedPurpose::rendering,
                    protocol, trial, timing);
}

}  // namespace foveola::study
