// What a scripted headset's eyes were shown.
#pragma once

#include <cstdint>

#include "renderer/image/image.h"
#include "tests/openxr/scripted_headset.h"

namespace foveola::test {

void wait_for_frame(const ScriptedHeadset& headset, std::int64_t number);

/// The picture of a frame that was saved, for eye 0 or 1: sRGB in [0, 1].
RgbImage saved_picture(const ScriptedHeadset& headset, std::int64_t frame, int eye);

}  // namespace foveola::test
