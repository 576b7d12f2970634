// What a trial is rendered with, whoever takes part.
#pragma once

#include "renderer/preview/preview.h"
#include "study/design/plan.h"
#include "study/protocol/protocol.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// The preview of a trial in the scene of `stage`. settings: those of the trial's scene and method
/// (see settings_of).
PreviewSettings trial_preview_settings(const Protocol& protocol, const TrialSettings& settings,
                                       const SceneStage& stage);

/// After how long a mark that has not come is censored; in a catch trial, after which it ends.
double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial);

}  // namespace foveola::study
