#include "renderer/headset/live_window.h"

#include <exception>
#include <thread>
#include <vector>

namespace foveola {

double said_refresh_rate_hz(const Window& window, int monitor, const DisplayProfile& display) {
  const std::vector<MonitorInfo> monitors = window.monitors();
  const auto number = static_cast<std::size_t>(monitor);
  const double said_hz = number < monitors.size() ? monitors[number].refresh_rate_hz : 0.0;
  return said_hz > 0.0 ? said_hz : display.refresh_rate_hz;
}

void run_beside(Window& window, const std::stop_token& stop,
                const std::function<void(const IVec2& framebuffer)>& work) {
  std::exception_ptr fault;
  {
    const IVec2 framebuffer = window.framebuffer_size();
    const std::jthread beside([&] {
      try {
        work(framebuffer);
      } catch (...) {
        fault = std::current_exception();
      }
      window.finish();
    });
    window.dispatch_events(stop);
  }
  if (fault) {
    std::rethrow_exception(fault);
  }
}

}  // namespace foveola
