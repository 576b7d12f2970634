// Where a display's timing patch is in a window.
#pragma once

#include "renderer/gaze/profiles.h"
#include "renderer/window/view_renderer.h"

namespace foveola {

/// The window's part that it fills, cut off by the window's edges.
WindowPart part_of(const TimingPatch& patch, const IVec2& framebuffer);

}  // namespace foveola
