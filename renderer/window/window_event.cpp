#include "renderer/window/window_event.h"

#include <utility>

namespace foveola {

void WindowEvents::push(WindowEvent event) {
  const std::scoped_lock lock(mutex_);
  events_.push_back(std::move(event));
}

std::vector<WindowEvent> WindowEvents::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(events_, {});
}

}  // namespace foveola
