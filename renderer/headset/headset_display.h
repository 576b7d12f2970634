// A headset's profile, as its runtime tells it.
#pragma once

#include "renderer/gaze/profiles.h"
#include "renderer/headset/headset_facts.h"

namespace foveola {

/// `profile`, of the kind openxr, with what it does not say itself: the views, the rate, and the
/// time until a frame is seen. Its size is that of one eye's picture.
DisplayProfile told_by(const HeadsetFacts& facts, DisplayProfile profile);

}  // namespace foveola
