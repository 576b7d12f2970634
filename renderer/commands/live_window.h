// What every command with a live window needs: how fast the display is, and a thread beside the
// window's.
#pragma once

#include <functional>
#include <stop_token>

#include "renderer/gaze/profiles.h"
#include "renderer/window/window.h"

namespace foveola {

/// The rate that the system says the monitor runs at, or its profile's if it says none.
double said_refresh_rate_hz(const Window& window, int monitor, const DisplayProfile& display);

/// Runs `work` in a thread of its own, with the window's size in pixels, while this one, which made
/// the window, passes on its events; until the work is done. Rethrows what it throws.
void run_beside(Window& window, const std::stop_token& stop,
                const std::function<void(const IVec2& framebuffer)>& work);

}  // namespace foveola
