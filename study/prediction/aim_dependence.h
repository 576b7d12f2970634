// Tests whether a sampler depends on its aim.
#pragma once

#include "renderer/view/view_sampler.h"

namespace foveola::study {

/// Returns whether a sampler that is aimed at `aim` samples elsewhere when only the gaze moves.
bool follows_gaze(ViewSampler& sampler, const Aim& aim);

/// Returns whether it samples elsewhere than with `other`, as far as is visible near the gaze of
/// `aim`.
bool follows_aim(ViewSampler& sampler, const Aim& aim, const Aim& other);

}  // namespace foveola::study
