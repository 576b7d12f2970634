#include "tests/openxr/runtime/session_states.h"

#include "tests/openxr/runtime/gl_context.h"
#include "tests/openxr/runtime/names.h"
#include "tests/openxr/runtime/times.h"

namespace foveola::test::openxr {
namespace {

double latest_time_s(const Session& session) {
  return session.frames.empty() ? Frame().time_s : session.frames.back().time_s;
}

void let_go_up_to(Session& session, XrSessionState highest) {
  session.highest_state = highest;
  settle(session);
}

void recentre(Session& session, const ScriptedEvent& event) {
  const XrTime display_time = session.frames.back().display_time;
  const XrTime change_time = display_time + nanoseconds(event.after_s);
  session.local_origins.emplace_back(change_time, session.local_origins.back().second * event.pose);
  XrEventDataReferenceSpaceChangePending pending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING};
  pending.session = session.handle;
  pending.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
  pending.changeTime = change_time;
  pending.poseValid = XR_TRUE;
  pending.poseInPreviousSpace = for_application(event.pose);
  queue_event(pending);
}

void lose(Session& session, bool is_instance_lost) {
  if (is_instance_lost) {
    XrEventDataInstanceLossPending pending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING};
    pending.lossTime = now() + nanoseconds(1.0);
    queue_event(pending);
  }
  session.is_loss_pending = true;
  enter(session, XR_SESSION_STATE_LOSS_PENDING);
}

void play(Session& session, const ScriptedEvent& event) {
  switch (event.kind) {
    case EventKind::recentre:
      recentre(session, event);
      break;
    case EventKind::taken_off:
      tell_presence(session, false);
      [[fallthrough]];
    case EventKind::focus_lost:
      let_go_up_to(session, XR_SESSION_STATE_VISIBLE);
      break;
    case EventKind::hidden:
      let_go_up_to(session, XR_SESSION_STATE_SYNCHRONIZED);
      break;
    case EventKind::put_on:
      tell_presence(session, true);
      [[fallthrough]];
    case EventKind::focus_gained:
    case EventKind::shown:
      let_go_up_to(session, XR_SESSION_STATE_FOCUSED);
      break;
    case EventKind::session_loss:
      lose(session, false);
      break;
    case EventKind::instance_loss:
      lose(session, true);
      break;
    case EventKind::session_lost:
      session.is_lost = true;
      break;
    case EventKind::exit:
      stop(session, AfterStopping::exit);
      break;
    case EventKind::restart:
      stop(session, AfterStopping::restart);
      break;
  }
}

bool is_between_ready_and_stopping(const Session& session) {
  return session.is_running && session.state <= XR_SESSION_STATE_FOCUSED;
}

}  // namespace

void enter(Session& session, XrSessionState state) {
  session.state = state;
  session.was_focused = session.was_focused || state == XR_SESSION_STATE_FOCUSED;
  XrEventDataSessionStateChanged changed{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
  changed.session = session.handle;
  changed.state = state;
  changed.time = now();
  queue_event(changed);
  runtime().log.write(
      {{"kind", "state"}, {"state", short_name(state)}, {"time_s", latest_time_s(session)}});
}

void rise_by_one(Session& session) {
  if (is_between_ready_and_stopping(session) && session.state < session.highest_state) {
    enter(session, static_cast<XrSessionState>(session.state + 1));
  }
}

void settle(Session& session) {
  while (is_between_ready_and_stopping(session) && session.state != session.highest_state) {
    const int step = session.state < session.highest_state ? 1 : -1;
    enter(session, static_cast<XrSessionState>(session.state + step));
  }
}

void stop(Session& session, AfterStopping next) {
  const XrSessionState highest = session.highest_state;
  let_go_up_to(session, XR_SESSION_STATE_SYNCHRONIZED);
  session.highest_state = highest;  // should it start again
  session.after_stopping = next;
  enter(session, XR_SESSION_STATE_STOPPING);
}

void play_events(Session& session, double time_s) {
  const std::vector<ScriptedEvent>& events = runtime().script.events;
  for (; session.events_played < events.size(); ++session.events_played) {
    const ScriptedEvent& event = events[session.events_played];
    if (event.time_s > time_s) {
      return;
    }
    const bool is_for_its_state =
        is_between_ready_and_stopping(session) || event.kind == EventKind::session_lost;
    if (event.session == session.number && is_for_its_state) {
      runtime().log.write({{"kind", "event"}, {"event", event.name}, {"time_s", time_s}});
      play(session, event);
    }
  }
}

void tell_presence([[maybe_unused]] const Session& session, [[maybe_unused]] bool is_present) {
#ifdef XR_EXT_user_presence
  if (is_enabled(XR_EXT_USER_PRESENCE_EXTENSION_NAME)) {
    XrEventDataUserPresenceChangedEXT changed{XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT};
    changed.session = session.handle;
    changed.isUserPresent = is_present ? XR_TRUE : XR_FALSE;
    queue_event(changed);
  }
#endif
}

void forget_session() {
  {
    const CurrentContext current(current_session().gl);
    for (const auto& [number, swapchain] : runtime().swapchains.all()) {
      remove_textures(swapchain->textures);
    }
  }
  runtime().swapchains.clear();
  runtime().spaces.clear();
  runtime().session.reset();
}

}  // namespace foveola::test::openxr
