#include "renderer/base/clock.h"

#include <ctime>

#include <fmt/chrono.h>

namespace foveola {

std::string utc_text(Nanoseconds since_1970) {
  const auto second = std::chrono::floor<std::chrono::seconds>(since_1970);
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(since_1970 - second);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z",
                     fmt::gmtime(static_cast<std::time_t>(second.count())), milliseconds.count());
}

std::string utc_now() { return utc_text(std::chrono::system_clock::now().time_since_epoch()); }

}  // namespace foveola
