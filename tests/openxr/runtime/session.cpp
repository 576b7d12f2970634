#include <bit>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/gl_context.h"
#include "tests/openxr/runtime/session_states.h"
#include "tests/openxr/runtime/state.h"
#include "tests/openxr/runtime/system.h"

namespace foveola::test::openxr {

XrResult create_session(XrInstance instance, const XrSessionCreateInfo* create_info,
                        XrSession* session) {
  const Instance& owner = instance_of(instance);
  const XrSessionCreateInfo& info =
      checked(create_info, XR_TYPE_SESSION_CREATE_INFO, "the information for the session");
  XrSession& place = place_for(session, "the place for the session");
  require(info.createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "there are no flags for sessions");
  require_system(info.systemId);
  require(!runtime().session, XR_ERROR_LIMIT_REACHED, "there is a session already");
  require(owner.are_graphics_requirements_known, XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING,
          "xrGetOpenGLGraphicsRequirementsKHR was not called before");
  Session made;
  made.gl = binding_of(info.next);
  made.number = ++runtime().sessions_of_script;
  made.handle = std::bit_cast<XrSession>(++runtime().sessions_made);
  made.local_origins.emplace_back(0, Pose());
  runtime().session = std::move(made);
  runtime().log.write({{"kind", "session"}, {"number", runtime().session->number}});
  enter(*runtime().session, XR_SESSION_STATE_IDLE);
  enter(*runtime().session, XR_SESSION_STATE_READY);
  place = runtime().session->handle;
  return XR_SUCCESS;
}

XrResult destroy_session(XrSession session) {
  session_of(session);
  forget_session();
  return XR_SUCCESS;
}

XrResult begin_session(XrSession session, const XrSessionBeginInfo* begin_info) {
  Session& begun = session_of(session);
  const XrSessionBeginInfo& info =
      checked(begin_info, XR_TYPE_SESSION_BEGIN_INFO, "the information to begin with");
  require(!begun.is_running, XR_ERROR_SESSION_RUNNING, "the session runs already");
  require(begun.state == XR_SESSION_STATE_READY, XR_ERROR_SESSION_NOT_READY,
          "the session's state is not READY");
  require_stereo(info.primaryViewConfigurationType);
  begun.is_running = true;
  begun.waited.reset();
  begun.begun.reset();
  tell_presence(begun, true);
  return XR_SUCCESS;
}

XrResult end_session(XrSession session) {
  Session& ended = running_session_of(session);
  require(ended.state == XR_SESSION_STATE_STOPPING, XR_ERROR_SESSION_NOT_STOPPING,
          "the session's state is not STOPPING");
  ended.is_running = false;
  runtime().frame_begun.notify_all();
  enter(ended, XR_SESSION_STATE_IDLE);
  enter(ended, ended.after_stopping == AfterStopping::exit ? XR_SESSION_STATE_EXITING
                                                           : XR_SESSION_STATE_READY);
  return XR_SUCCESS;
}

XrResult request_exit_session(XrSession session) {
  Session& leaving = running_session_of(session);
  if (leaving.state != XR_SESSION_STATE_STOPPING) {
    stop(leaving, AfterStopping::exit);
  }
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
