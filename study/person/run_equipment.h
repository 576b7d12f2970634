// What a run's settings and its protocol ask for: the display, the tracker, and what the gaze goes
// through.
#pragma once

#include <string>
#include <vector>

#include "study/person/run_person.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Each that is not in the settings is the protocol's, or the usual one. Throw Error if there is no
/// such profile.
DisplayProfile display_of(const RunSettings& settings, const Protocol& protocol);
TrackerProfile tracker_of(const RunSettings& settings, const Protocol& protocol);

/// The protocol with the settings' filter of the gaze. Throws Error if it cannot be read.
Protocol protocol_of(const RunSettings& settings);

/// The size of the narrowest 360-degree image of any trial, in pixels.
IVec2 smallest_film(const Protocol& protocol);

/// Whether it is nobody's who sits there: simulated, or recorded before.
bool is_nobodys_eye(TrackerSource source);

/// Throws Error if a person's session that counts would have nobody's eye; a rehearsal may.
void require_real_gaze(const TrackerProfile& tracker, SessionKind kind);

/// The session's note if it has nobody's eye, which must not be taken for a person's; else empty.
std::vector<std::string> notes_of_eye(const TrackerProfile& tracker);

}  // namespace foveola::study
