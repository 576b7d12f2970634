// Profiles of eye trackers, for studies that name one.
#pragma once

#include <string>

#include <fmt/format.h>

namespace foveola::test {

/// As TOML, which a source's own table may follow. Its stages take no time.
inline std::string tracker_profile(const std::string& source, int rate_hz) {
  return fmt::format(R"(title = "A tracker of the tests"
source = "{}"
rate_hz = {}
exposure = {{ duration_ms = 0.0, provenance = "assumed" }}
transfer = {{ duration_ms = 0.0, provenance = "assumed" }}
processing = {{ duration_ms = 0.0, provenance = "assumed" }}
)",
                     source, rate_hz);
}

/// Of a tracker that speaks the Open Gaze API at a port of this machine.
inline std::string open_gaze_profile(int port) {
  return tracker_profile("open-gaze", 60) +
         fmt::format("[open_gaze]\nhost = \"127.0.0.1\"\nport = {}\n", port);
}

}  // namespace foveola::test
