// Simulates a study in real time: its participants use the real window, one after the other.
#pragma once

#include <stop_token>

#include "study/record/setup/simulation_kind.h"
#include "study/simulation/study_simulation.h"

namespace foveola::study {

/// Returns the protocol's view as a display: as many pixels and the same fields of view as in
/// virtual time, for each eye of a headset, or on a monitor of that size.
DisplayProfile shown_display(const Protocol& protocol);

/// Call in the program's first thread, which owns the window. Fills in the study's `run_in_window`
/// and devices. When `stop` is requested, the session is recorded as interrupted. Throws Error if
/// there is no display to open a window on.
SimulateReport run_in_real_time(SimulatedStudy& study, const SimulationKind& kind,
                                const std::stop_token& stop);

}  // namespace foveola::study
