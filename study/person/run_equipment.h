// Selects the display, the tracker and the gaze filter of a run, from its settings and protocol.
#pragma once

#include <string>
#include <vector>

#include "study/person/run_person.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// The settings take precedence over the protocol, and the protocol over the default. These throw
/// Error if there is not such a profile.
DisplayProfile display_of(const RunSettings& settings, const Protocol& protocol);
TrackerProfile tracker_of(const RunSettings& settings, const Protocol& protocol);

/// Returns the protocol with the settings' gaze filter. Throws Error if it cannot be read.
Protocol protocol_of(const RunSettings& settings);

/// Returns the size of the narrowest 360-degree image of any trial, in pixels.
IVec2 smallest_film(const Protocol& protocol);

/// Returns whether the gaze is not a person's: simulated or recorded.
bool is_nobodys_eye(TrackerSource source);

/// Throws Error if a session that counts would not have a person's gaze. Rehearsals need none.
void require_real_gaze(const TrackerProfile& tracker, SessionKind kind);

/// The session's note if it has nobody's eye, which must not be taken for a person's; else empty.
std::vector<std::string> notes_of_eye(const TrackerProfile& tracker);

}  // namespace foveola::study
