// Writes a session's events; each takes effect only once it is durable.
#pragma once

#include <deque>
#include <future>
#include <vector>

#include "study/record/write/session_recorder.h"
#include "study/session/session.h"

namespace foveola::study {

/// A durable event, with the state after it and its effects.
struct DurableEvent {
  Nanoseconds time{0};  ///< session clock
  Event event;
  SessionState after;
  std::vector<Effect> effects;
};

/// Takes the session's steps at once, and does not wait for the disk: a commit must not delay a
/// frame.
class SessionLog {
 public:
  /// state: to resume from. recorder: must outlive this.
  SessionLog(Procedure procedure, SessionState state, SessionRecorder& recorder);

  const Procedure& procedure() const { return procedure_; }
  /// State after all events, durable or not.
  const SessionState& state() const { return state_; }

  /// Records an event, at its own time if it carries one, else at `now`. Returns false, and does
  /// nothing, if it is not allowed in this state.
  bool record_event(Nanoseconds now, const Event& event);

  /// Whether effects are pending: until then the participant has not seen the question of an
  /// answer.
  bool has_effects_to_come() const;

  /// Returns the events that became durable since the last call, in order. Rethrows the error of
  /// one that could not be written.
  std::vector<DurableEvent> take_durable();

  /// As take_durable, after waiting for all of them.
  std::vector<DurableEvent> wait_for_all();

 private:
  struct Pending {
    DurableEvent event;
    std::future<void> written;
  };

  Procedure procedure_;
  SessionState state_;
  SessionRecorder& recorder_;
  std::deque<Pending> pending_;
};

}  // namespace foveola::study
