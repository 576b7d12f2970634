// Whether a sampler depends on where it is aimed.
#pragma once

#include "renderer/view/view_sampler.h"

namespace foveola::study {

/// Whether a sampler that is aimed at `aim` goes elsewhere when only the gaze moves.
bool follows_gaze(ViewSampler& sampler, const Aim& aim);

/// Whether it goes elsewhere than with `other`, as far as is seen near the gaze of `aim`.
bool follows_aim(ViewSampler& sampler, const Aim& aim, const Aim& other);

}  // namespace foveola::study
