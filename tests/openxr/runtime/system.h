// The only headset.
#pragma once

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

constexpr XrSystemId the_system = 1;

/// Refuse others than the only ones.
void require_system(XrSystemId system);
void require_stereo(XrViewConfigurationType type);

/// That the application may use.
bool has_eye_tracker();

}  // namespace foveola::test::openxr
