// Whether what was measured before a session is good enough, and how that is said and kept.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/preflight/preflight.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

enum class PreflightVerdict {
  good,
  warned,   ///< it misses a usual limit, which is ours
  refused,  ///< it misses what the protocol asks for
};

struct PreflightCheck {
  std::string name;
  std::string found;  ///< in words, with units
  std::string limit;  ///< in words; empty if there is none
  PreflightVerdict verdict = PreflightVerdict::good;
};

std::vector<PreflightCheck> check_preflight(const Preflight& preflight, const PreflightGate& gate);

/// Throws Error, which names them, if checks miss what the protocol asks for.
void require_gate(const std::vector<PreflightCheck>& checks);

/// "preflight" of SessionFacts::devices: the figures and what came of them.
nlohmann::ordered_json preflight_json(const Preflight& preflight,
                                      const std::vector<PreflightCheck>& checks);

/// A table of lines for the experimenter.
std::string preflight_table(const std::vector<PreflightCheck>& checks);

/// What is to be read before all else, in large letters: that the eye is not a participant's, or
/// that a monitor stands in for a headset; empty if there is nothing of the kind. is_pilot: then it
/// names what a monitor can be rehearsed with.
std::string preflight_banner(const Preflight& preflight, bool is_pilot);

}  // namespace foveola::study
