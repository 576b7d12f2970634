// Counts frames and gaze samples live, for the experimenter.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "study/console/session_status.h"

namespace foveola::study {

/// All times are of one clock.
class LiveFigures {
 public:
  void begin_attempt();
  void add_attempt_frame(bool is_late);
  /// Call after each frame, inside or outside of attempts. arrived: the gaze samples of this frame.
  void add_frame(Nanoseconds shown, std::span<const GazeSample> arrived);

  FrameStatus frames(double refresh_rate_hz) const;
  GazeStatus gaze(const char* eye, Nanoseconds now) const;

 private:
  struct Counted {
    Nanoseconds begin{0};
    Nanoseconds end{0};
    std::uint64_t frames = 0;
    std::uint64_t samples = 0;
    std::uint64_t valid = 0;
  };

  std::optional<Counted> current_;
  std::optional<Counted> last_second_;
  std::optional<Nanoseconds> newest_valid_;
  std::uint64_t attempt_frames_ = 0;
  std::uint64_t attempt_late_ = 0;
};

}  // namespace foveola::study
