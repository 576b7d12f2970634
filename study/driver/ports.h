// Ports of a session's driver. Virtual time, a window, a headset and a replay differ only in these:
// their clock, display and input.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/base/clock.h"
#include "study/driver/session_log.h"

namespace foveola::study {

class SessionDriver;

// All times at the ports are of the session's clock.

class ClockPort {
 public:
  virtual ~ClockPort() = default;
  /// Returns the session's time; a resumed session's continues from its last event.
  virtual Nanoseconds now() const = 0;
};

/// One attempt at a trial, from its first frame on.
class AttemptPort {
 public:
  virtual ~AttemptPort() = default;
  /// Presents at least the next frame and, if frames can be skipped, continues until one is
  /// presented at `until` or later. Returns the time at which the last one was presented.
  virtual Nanoseconds show(Nanoseconds until) = 0;
  /// Call before an event that ends the attempt is recorded: passes all its frames to the record,
  /// because that event states their number. Frames shown until the event is durable are not
  /// recorded. May be called again.
  virtual void complete_record() {}
  virtual std::uint64_t samples() const = 0;
  virtual std::uint64_t non_finite() const = 0;
};

/// The display. It is told of durable state only: nothing else may be seen.
class DisplayPort {
 public:
  virtual ~DisplayPort() = default;
  /// Shows a durable event; its effects follow.
  virtual void follow(const DurableEvent& event) = 0;
  /// Shows an effect: a question, or the end of something. Attempts begin and end by themselves.
  virtual void carry_out(const Effect& effect) = 0;
  /// Begins to render the driver's current trial. Empty if it must wait, for instance for gaze; the
  /// driver then asks again before each frame.
  virtual std::unique_ptr<AttemptPort> begin_attempt() = 0;
  /// Call before each frame.
  virtual void begin_frame() {}
  /// Shows a frame outside of attempts. Returns the time at which it was shown.
  virtual Nanoseconds show() = 0;
  /// Call after each frame, also those of attempts.
  virtual void end_frame(Nanoseconds /*shown*/) {}
};

/// Input: a person's keys and the experimenter's console, or a simulated participant.
class InputPort {
 public:
  virtual ~InputPort() = default;
  /// Feeds the answers, keys and commands since the last call to the driver. Called before each
  /// frame, also while effects are pending.
  virtual void pass_input(SessionDriver& driver) = 0;
  /// Returns the time of the mark's key press if it is known in advance: frames need not be shown
  /// beyond it.
  virtual std::optional<Nanoseconds> next_press() const { return std::nullopt; }
};

}  // namespace foveola::study
