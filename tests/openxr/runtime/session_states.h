// Through which states a session goes, and why.
#pragma once

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {

/// Tells the application and the log.
void enter(Session& session, XrSessionState state);

/// A running session, one state at a time, as near to its highest as it is let: up by one at most
/// if it is still starting, or all the way.
void rise_by_one(Session& session);
void settle(Session& session);

/// Down to STOPPING.
void stop(Session& session, AfterStopping next);

/// What the script has for this time and was not played yet.
void play_events(Session& session, double time_s);

/// Tells that the wearer is there or not, where the application has asked for that.
void tell_presence(const Session& session, bool is_present);

/// With all that belongs to it.
void forget_session();

}  // namespace foveola::test::openxr
