// Waiting for what the kernel or another thread does in its own time.
#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

namespace foveola::test {

/// Longer than anything takes on a machine that does ten things at once.
constexpr std::chrono::minutes patience{5};

/// Waits until `holds`, however slow the machine; throws std::runtime_error if it never does.
inline void wait_until(const std::string& what, const std::function<bool()>& holds) {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + patience; !holds();) {
    if (Clock::now() > end) {
      throw std::runtime_error("waited in vain: " + what);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace foveola::test
