// Common parts of commands with a live window: the display's rate, and a thread beside the
// window's.
#pragma once

#include <functional>
#include <stop_token>

#include "renderer/base/work/work_scope.h"
#include "renderer/gaze/profiles.h"
#include "renderer/window/window.h"
#include "renderer/window/window_event.h"

namespace foveola {

/// The monitor's rate by the system, or its profile's if the system has none.
double said_refresh_rate_hz(const Window& window, int monitor, const DisplayProfile& display);

/// Runs `work` in its own thread, with the window's size in pixels, while this thread, which
/// created the window, passes on its events; until the work is done. Rethrows its exceptions.
void run_beside(Window& window, const std::stop_token& stop,
                const std::function<void(const IVec2& framebuffer)>& work);

/// load_watched for a window's content, which also stops if the user wants to leave: see
/// WindowEvents::closing.
template <typename Load>
auto load_beside(const WindowEvents& events, const std::stop_token& stop, const Load& load) {
  std::stop_source either;
  const auto request = [&] { either.request_stop(); };
  const std::stop_callback by_program(stop, request);
  const std::stop_callback by_user(events.closing(), request);
  return load_watched(either.get_token(), load);
}

}  // namespace foveola
