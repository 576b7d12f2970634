// Creates an OpenXR session that draws with OpenGL on X: separate, because of X's own header.
#pragma once

#include "renderer/headset/xr_instance.h"

namespace foveola {

/// Uses this thread's current GLX context. Throws Error if there is none, or if the runtime does
/// not support it.
XrSession make_glx_session(const XrInstanceOwner& instance);

/// The size of the current drawable, in pixels.
IVec2 current_drawable_px();

}  // namespace foveola
