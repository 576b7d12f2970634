// A session of OpenXR that draws with OpenGL on X: apart, for the sake of X's own header.
#pragma once

#include "renderer/headset/xr_instance.h"

namespace foveola {

/// With the context of GLX that is current in this thread. Throws Error if there is none, or the
/// runtime cannot use it.
XrSession make_glx_session(const XrInstanceOwner& instance);

/// The size of what is current there, in pixels.
IVec2 current_drawable_px();

}  // namespace foveola
