// Derives independent seeds for all random draws from one session's seed.
#pragma once

#include <cstdint>
#include <initializer_list>

#include "renderer/base/numbers/random.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/session/session.h"

namespace foveola::study {

/// The use of a seed; keeps the streams apart.
enum class SeedPurpose : std::uint32_t {
  participant = 1,  ///< a simulated participant's traits
  tracker = 2,      ///< a simulated tracker's noise
  rendering = 3,    ///< a trial's sample points and light paths
  conduct = 4,      ///< a simulated participant's actions, per timing
  waiting = 5,      ///< waits before the stimuli of the reaction test
  picture = 6,      ///< choice of a predicted trial's picture
};

/// The recorded randomness of a session.
struct SessionSeed {
  std::uint64_t seed = 0;
  int design_row = 0;
};

/// Returns the seed for `purpose` at `place`, such as {step, repetition}.
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

/// Returns the seed for `purpose` in one timing of a trial. An attempt that a pause or a crash
/// ended shares its seed with the repetition, so that a session's results do not depend on
/// interruptions.
inline std::uint32_t trial_seed(const SessionSeed& session, SeedPurpose purpose,
                                const Protocol& protocol, const PlannedTrial& trial, int timing) {
  return derive_seed(session, purpose,
                     {static_cast<int>(scene_index(protocol, trial.scene)),
                      static_cast<int>(method_index(protocol, trial.method)), timing,
                      static_cast<int>(trial.kind)});
}

/// Returns the seed of a predicted trial's picture, the same for all its timings.
inline std::uint32_t picture_seed(const SessionSeed& session, const Protocol& protocol,
                                  const PlannedTrial& trial) {
  return trial_seed(session, SeedPurpose::picture, protocol, trial, 0);
}

/// Returns the seed for `purpose` of the next try of the agenda step in `state`.
inline std::uint32_t step_seed(const SessionSeed& session, SeedPurpose purpose,
                               const SessionState& state) {
  return derive_seed(session, purpose,
                     {static_cast<int>(state.step), state.validations_left, state.presses_left});
}

/// Returns the seed of a trial's sample points and light paths: with the recorded frames it
/// reproduces the film.
inline std::uint32_t rendering_seed(std::uint64_t session_seed, int design_row,
                                    const Protocol& protocol, const PlannedTrial& trial,
                                    int timing) {
  return trial_seed({.seed = session_seed, .design_row = design_row}, SeedPurpose::rendering,
                    protocol, trial, timing);
}

}  // namespace foveola::study
