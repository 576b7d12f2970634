#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

void enter(Session& session, XrSessionState state) {
  session.state = state;
  session.was_focused = session.was_focused || state == XR_SESSION_STATE_FOCUSED;
  XrEventDataSessionStateChanged changed{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED};
  changed.session = handle_of<XrSession>(session);
  changed.state = state;
  changed.time = now();
  queue_event(changed);
}

bool is_between_ready_and_stopping(const Session& session) {
  return session.is_running && session.state <= XR_SESSION_STATE_FOCUSED;
}

/// Goes through all states on the way.
void let_go_up_to(Session& session, XrSessionState state) {
  session.max_state = state;
  while (session.state != state) {
    enter(session, static_cast<XrSessionState>(session.state + (session.state < state ? 1 : -1)));
  }
}

void tell_presence([[maybe_unused]] Session& session, [[maybe_unused]] bool is_present) {
#ifdef XR_EXT_user_presence
  if (is_enabled(XR_EXT_USER_PRESENCE_EXTENSION_NAME)) {
    XrEventDataUserPresenceChangedEXT changed{XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT};
    changed.session = handle_of<XrSession>(session);
    changed.isUserPresent = is_present ? XR_TRUE : XR_FALSE;
    queue_event(changed);
  }
#endif
}

void recentre(Session& session, double yaw_deg) {
  session.local_yaw_deg += yaw_deg;
  XrEventDataReferenceSpaceChangePending pending{XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING};
  pending.session = handle_of<XrSession>(session);
  pending.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_LOCAL;
  pending.changeTime = now();
  pending.poseValid = XR_TRUE;
  pending.poseInPreviousSpace = to_xr({rotation({.yaw_deg = yaw_deg})});
  queue_event(pending);
}

void play(Session& session, const ScriptedEvent& event) {
  if (event.name == "recentre") {
    recentre(session, event.yaw_deg);
  } else if (event.name == "focus_lost") {
    let_go_up_to(session, XR_SESSION_STATE_VISIBLE);
  } else if (event.name == "hidden") {
    let_go_up_to(session, XR_SESSION_STATE_SYNCHRONIZED);
  } else if (event.name == "focus_gained") {
    let_go_up_to(session, XR_SESSION_STATE_FOCUSED);
  } else if (event.name == "taken_off") {
    tell_presence(session, false);
    let_go_up_to(session, XR_SESSION_STATE_VISIBLE);
  } else if (event.name == "put_on") {
    tell_presence(session, true);
    let_go_up_to(session, XR_SESSION_STATE_FOCUSED);
  } else if (event.name == "session_loss") {
    session.is_loss_pending = true;
    enter(session, XR_SESSION_STATE_LOSS_PENDING);
  } else if (event.name == "exit") {
    let_go_up_to(session, XR_SESSION_STATE_SYNCHRONIZED);
    enter(session, XR_SESSION_STATE_STOPPING);
  } else {
    throw std::runtime_error("the script: there is no event " + event.name);
  }
}

/// Refuses an application's OpenGL that no session could use.
GLXContext checked_context(const void* next) {
  constexpr XrResult invalid = XR_ERROR_GRAPHICS_DEVICE_INVALID;
  const auto* const binding =
      chained<XrGraphicsBindingOpenGLXlibKHR>(next, XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
  require(binding != nullptr && is_enabled(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME), invalid,
          "the session has no OpenGL");
  require(binding->glxDrawable != 0 && binding->visualid != 0, invalid,
          "the binding has no drawable or no visual");
  int bound = 0;
  glXGetFBConfigAttrib(binding->xDisplay, binding->glxFBConfig, GLX_FBCONFIG_ID, &bound);
  int used = 0;
  glXQueryContext(binding->xDisplay, binding->glxContext, GLX_FBCONFIG_ID, &used);
  require(bound == used, invalid, "the binding's GLXFBConfig is not that of its context");
  return binding->glxContext;
}

}  // namespace

void play_events(Session& session, double time_s) {
  const std::vector<ScriptedEvent>& events = runtime().script.events;
  for (; session.events_played < events.size(); ++session.events_played) {
    const ScriptedEvent& event = events[session.events_played];
    if (event.time_s > time_s) {
      return;
    }
    if (event.session == session.number && is_between_ready_and_stopping(session)) {
      play(session, event);
    }
  }
}

void rise_by_one(Session& session) {
  if (is_between_ready_and_stopping(session) && session.state < session.max_state) {
    enter(session, static_cast<XrSessionState>(session.state + 1));
  }
}

XrResult CreateSession(XrInstance /*instance*/, const XrSessionCreateInfo* info,
                       XrSession* session) {
  require(!runtime().session, XR_ERROR_LIMIT_REACHED, "there is a session already");
  require(runtime().instance->are_graphics_requirements_known,
          XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
          "xrGetOpenGLGraphicsRequirementsKHR was not called before");
  Session& made = runtime().session.emplace();
  made.gl = checked_context(info->next);
  made.number = ++runtime().sessions;
  enter(made, XR_SESSION_STATE_IDLE);
  enter(made, XR_SESSION_STATE_READY);
  *session = handle_of<XrSession>(made);
  return XR_SUCCESS;
}

XrResult DestroySession(XrSession /*session*/) {
  for (const Swapchain& swapchain : runtime().session->swapchains) {
    glDeleteTextures(static_cast<GLsizei>(swapchain.textures.size()), swapchain.textures.data());
  }
  runtime().session.reset();
  return XR_SUCCESS;
}

XrResult BeginSession(XrSession session, const XrSessionBeginInfo* info) {
  auto& begun = object_of<Session>(session);
  require(!begun.is_running && begun.state == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY,
          "the session's state is not READY");
  require(info->primaryViewConfigurationType == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO,
          XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "there are two eyes");
  begun.is_running = true;
  tell_presence(begun, true);
  return XR_SUCCESS;
}

XrResult EndSession(XrSession session) {
  auto& ended = object_of<Session>(session);
  require(ended.is_running && ended.state == XR_SESSION_STATE_STOPPING,
          XR_ERROR_SESSION_NOT_STOPPING, "the session's state is not STOPPING");
  ended.is_running = false;
  enter(ended, XR_SESSION_STATE_IDLE);
  enter(ended, XR_SESSION_STATE_EXITING);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
