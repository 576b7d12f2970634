// What one session records, and the interface that takes it, whenever it then reaches the disk.
#pragma once

#include <cstdint>
#include <future>
#include <string>
#include <variant>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"
#include "study/session/session.h"

namespace foveola::study {

/// One rendered frame, as it is kept.
struct FrameRow {
  Nanoseconds time{0};       ///< session clock: head and gaze were polled
  Nanoseconds presented{0};  ///< session clock: it was on the display
  float head_azimuth_rad = 0.0F;
  float head_elevation_rad = 0.0F;
  float head_roll_rad = 0.0F;  ///< a multiple of 1/65536 of a turn, in [-pi, pi)
  Vec3 gaze{0.0F};             ///< world axes: the gaze that the frame was rendered for
  bool gaze_valid = false;
  bool gaze_held = false;
  bool is_late = false;  ///< it missed its refresh
  Nanoseconds gaze_age{0};
  std::uint32_t samples = 0;
};

/// What the film was after a frame, so that a replay can be checked.
struct FilmHash {
  std::uint64_t frame = 0;  ///< counted from the attempt's start
  std::string sha256;
};

/// An attempt at a trial of the session.
struct AttemptKey {
  std::size_t trial = 0;  ///< index into the plan
  int attempt = 1;
};

/// An event, which took the session from one state to the other.
struct EventEntry {
  Nanoseconds time{0};  ///< session clock
  Event event;
  SessionState before;
  SessionState after;
};

/// Consecutive frames of one attempt, at least one.
struct FrameChunk {
  AttemptKey attempt;
  std::uint64_t first = 0;  ///< counted from the attempt's start
  std::vector<FrameRow> frames;
};

/// Consecutive gaze samples of one attempt, at least one.
struct GazeChunk {
  AttemptKey attempt;
  std::uint64_t first = 0;  ///< counted from the attempt's start
  std::vector<GazeSample> samples;
};

struct FilmEntry {
  AttemptKey attempt;
  FilmHash hash;
};

using SessionEntry = std::variant<EventEntry, FrameChunk, GazeChunk, FilmEntry>;

/// The record of one session. Implementations differ only in when an entry reaches the disk: at
/// once (StoreRecorder), soon, by a thread of its own (ThreadedRecorder), or with the whole session
/// (BufferedRecorder). Entries reach it in the order in which they were recorded.
class SessionRecorder {
 public:
  virtual ~SessionRecorder() = default;

  /// The future is ready once the participant may know of the entry. What keeps an entry from the
  /// disk is thrown here or by the future, and then by all later ones.
  virtual std::future<void> record(SessionEntry entry) = 0;
};

/// The future of an entry that is already recorded.
inline std::future<void> already_recorded() {
  std::promise<void> recorded;
  recorded.set_value();
  return recorded.get_future();
}

}  // namespace foveola::study
