// Settings for rendering trials, for people and simulated participants alike.
#pragma once

#include <cstdint>

#include "renderer/preview/preview.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// Returns the preview of a trial in the scene of `stage`. settings: those of the trial's scene and
/// method (see settings_of).
PreviewSettings trial_preview_settings(const Protocol& protocol, const TrialSettings& settings,
                                       const SceneStage& stage);

/// Returns whether the trial is traced: a catch trial shows black frames.
bool is_rendered(const PlannedTrial& trial);

/// Returns the number of samples that the machine traces in this many frames of the trial.
std::uint64_t samples_after(std::uint64_t frames, const MachineModel& machine,
                            const PlannedTrial& trial);

/// Returns the time after which a missing mark is right-censored, or a catch trial ends.
double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial);

}  // namespace foveola::study
