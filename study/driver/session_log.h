// A session on its way to the disk: an event has its effects only once it is there.
#pragma once

#include <deque>
#include <future>
#include <vector>

#include "study/record/session_recorder.h"
#include "study/session/session.h"

namespace foveola::study {

/// An event that is on the disk, what it led to, and what the controller does now.
struct DurableEvent {
  Nanoseconds time{0};  ///< session clock
  Event event;
  SessionState after;
  std::vector<Effect> effects;
};

/// Takes the session's steps at once, and waits for the disk beside whoever feeds it: a frame must
/// not wait for a commit.
class SessionLog {
 public:
  /// state: to go on from. recorder: must outlive this.
  SessionLog(Procedure procedure, SessionState state, SessionRecorder& recorder);

  const Procedure& procedure() const { return procedure_; }
  /// After all that was fed, on the disk or not.
  const SessionState& state() const { return state_; }

  /// An event that carries a time happened then, another one `now`. Returns false, and does
  /// nothing, if it is not allowed in this state.
  bool feed(Nanoseconds now, const Event& event);

  /// Whether effects are still to come: until then the participant has not seen what an answer
  /// would be to.
  bool has_effects_to_come() const;

  /// The events that have reached the disk since the last call, in order. Rethrows what kept one
  /// from it.
  std::vector<DurableEvent> take_durable();

  /// The same, once all of them are there.
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
