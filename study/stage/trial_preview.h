// The settings that a trial is rendered with, for people and simulated participants alike.
#pragma once

#include <cstdint>

#include "renderer/preview/preview.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// The preview of a trial in the scene of `stage`. settings: those of the trial's scene and method
/// (see settings_of).
PreviewSettings trial_preview_settings(const Protocol& protocol, const TrialSettings& settings,
                                       const SceneStage& stage);

/// Whether anything is traced in the trial: a catch trial shows black frames.
bool is_rendered(const PlannedTrial& trial);

/// How many samples the machine has traced after this many frames of the trial.
std::uint64_t samples_after(std::uint64_t frames, const MachineModel& machine,
                            const PlannedTrial& trial);

/// The time after which a missing mark is right-censored; a catch trial ends after it.
double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial);

}  // namespace foveola::study
