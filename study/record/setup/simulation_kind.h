// How a study is simulated: what all of its simulated sessions must have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

struct SimulationKind {
  double scale = 1.0;  ///< see scaled_protocol
  /// Of the machine at full size, instead of the protocol's; empty: the protocol's.
  std::optional<double> samples_per_second{};
  bool predicted = false;     ///< nothing was rendered
  bool real_time = false;     ///< before the real window, at the speed of the machine
  std::string injected;       ///< the effect that was injected; empty: none
  std::string people_sha256;  ///< hash of the population's file
};

/// The protocol as its simulated sessions see it: the machine's speed, then the scale. Throws
/// UsageError for a speed that no protocol may have, and as scaled_protocol does.
Protocol simulated_protocol(Protocol protocol, const SimulationKind& kind);

/// Writes it as SessionFacts::devices.
std::string devices_of(const SimulationKind& kind);

/// Reads it from a session's devices; empty for a person's, and for one of before there were kinds.
std::optional<SimulationKind> simulation_kind_in(const std::string& devices);

/// Throws Error unless every simulated one of `sessions`, of the study at `database`, is of `kind`:
/// results of two would be taken for one.
void require_same_kind(const std::string& database, const std::vector<KnownSession>& sessions,
                       const SimulationKind& kind);

}  // namespace foveola::study
