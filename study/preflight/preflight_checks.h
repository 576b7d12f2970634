// Checks the preflight measurements against limits, and reports them.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/preflight/preflight.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

enum class PreflightVerdict {
  good,
  warned,   ///< beyond a default limit of Foveola
  refused,  ///< beyond the protocol's limit
};

struct PreflightCheck {
  std::string name;
  std::string found;  ///< in words, with units
  std::string limit;  ///< in words; empty if there is none
  PreflightVerdict verdict = PreflightVerdict::good;
};

std::vector<PreflightCheck> check_preflight(const Preflight& preflight, const PreflightGate& gate);

/// Throws Error, which names the checks, if any misses the protocol's limit.
void require_gate(const std::vector<PreflightCheck>& checks);

/// Returns "preflight" of SessionFacts::devices: the measured values and the results of the checks.
nlohmann::ordered_json preflight_json(const Preflight& preflight,
                                      const std::vector<PreflightCheck>& checks);

/// Returns a table of lines for the experimenter.
std::string preflight_table(const std::vector<PreflightCheck>& checks);

/// Returns the most important warning in capitals: the eye is not a participant's, or a monitor
/// replaces a headset; empty if neither. is_pilot: also names the profiles for rehearsing on a
/// monitor.
std::string preflight_banner(const Preflight& preflight, bool is_pilot);

}  // namespace foveola::study
