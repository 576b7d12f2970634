// What the driver of a session needs of the world. Virtual time, real time in a window, a headset
// and a replay differ in these ports alone: in their clock, in what they show, and in who answers.
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
  /// The session's time; goes on from where it was when a session is resumed.
  virtual Nanoseconds now() const = 0;
};

/// One attempt at a trial, from its first frame on.
class AttemptPort {
 public:
  virtual ~AttemptPort() = default;
  /// Presents at least the next frame and, where frames can be skipped, goes on until one is
  /// presented at `until` or later. Returns when the last one was presented.
  virtual Nanoseconds show(Nanoseconds until) = 0;
  /// An event that ends the attempt is about to be recorded: hands to the record what it does not
  /// have yet, since that event states what there is. Frames that are shown until the event is on
  /// the disk are not recorded. May be called again.
  virtual void complete_record() {}
  virtual std::uint64_t samples() const = 0;
  virtual std::uint64_t non_finite() const = 0;
};

/// What is shown. Called only with what is on the disk: nothing else may be seen.
class DisplayPort {
 public:
  virtual ~DisplayPort() = default;
  /// An event is on the disk; its effects follow.
  virtual void follow(const DurableEvent& event) = 0;
  /// The session now asks for something, or something has ended; attempts have begun and ended by
  /// themselves.
  virtual void carry_out(const Effect& effect) = 0;
  /// Begins to render the trial that the driver is in. Empty if it has to wait, for instance for
  /// a gaze: then it is asked for again before each frame.
  virtual std::unique_ptr<AttemptPort> begin_attempt() = 0;
  /// Before each frame.
  virtual void begin_frame() {}
  /// A frame outside of attempts. Returns when it was shown.
  virtual Nanoseconds show() = 0;
  /// After each frame, also those of attempts.
  virtual void end_frame(Nanoseconds /*shown*/) {}
};

/// Whoever answers: a person's keys and the experimenter's console, or a simulated participant.
class InputPort {
 public:
  virtual ~InputPort() = default;
  /// Feeds to the driver what was answered, pressed or said since the last call. Called before each
  /// frame, also while effects are still to come.
  virtual void act(SessionDriver& driver) = 0;
  /// When the mark's key goes down, if that is known beforehand: frames need not be shown for
  /// longer than that.
  virtual std::optional<Nanoseconds> next_press() const { return std::nullopt; }
};

}  // namespace foveola::study
