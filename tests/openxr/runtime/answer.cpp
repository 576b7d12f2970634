#include "tests/openxr/runtime/answer.h"

#include <array>
#include <iostream>
#include <string_view>

#include <fmt/format.h>

#include "tests/openxr/runtime/names.h"
#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

/// Whether the function may answer that the session is about to be lost.
bool may_tell_of_loss(std::string_view function) {
  constexpr std::array<std::string_view, 28> names = {"xrAcquireSwapchainImage",
                                                      "xrApplyHapticFeedback",
                                                      "xrAttachSessionActionSets",
                                                      "xrBeginFrame",
                                                      "xrBeginSession",
                                                      "xrCreateActionSpace",
                                                      "xrCreateReferenceSpace",
                                                      "xrCreateSwapchain",
                                                      "xrEndFrame",
                                                      "xrEndSession",
                                                      "xrEnumerateBoundSourcesForAction",
                                                      "xrEnumerateReferenceSpaces",
                                                      "xrEnumerateSwapchainFormats",
                                                      "xrEnumerateSwapchainImages",
                                                      "xrGetActionStateBoolean",
                                                      "xrGetActionStateFloat",
                                                      "xrGetActionStatePose",
                                                      "xrGetActionStateVector2f",
                                                      "xrGetCurrentInteractionProfile",
                                                      "xrGetVisibilityMaskKHR",
                                                      "xrLocateSpace",
                                                      "xrLocateViews",
                                                      "xrReleaseSwapchainImage",
                                                      "xrRequestExitSession",
                                                      "xrStopHapticFeedback",
                                                      "xrSyncActions",
                                                      "xrWaitFrame",
                                                      "xrWaitSwapchainImage"};
  return std::find(names.begin(), names.end(), function) != names.end();
}

/// The script's answer instead of the call's.
void fail_if_scripted(std::string_view function) {
  const std::optional<Session>& session = runtime().session;
  const double time_s = session && !session->frames.empty() ? session->frames.back().time_s : -1.0;
  for (ScriptedFailure& failure : runtime().script.failures) {
    const bool is_time = !failure.time_s || time_s >= *failure.time_s;
    if (failure.function == function && failure.times > 0 && is_time) {
      --failure.times;
      throw Refusal(failure.result, "the script says so");
    }
  }
}

void fail_if_lost(std::string_view function) {
  const bool is_lost = runtime().session && runtime().session->is_lost;
  require(!is_lost || !may_tell_of_loss(function), XR_ERROR_SESSION_LOST, "the session is lost");
}

XrResult refused(const char* function, XrResult result, const std::string& why) {
  runtime().log.write({{"kind", "error"},
                       {"function", function},
                       {"result", name_of(result).value_or(std::to_string(result))},
                       {"why", why}});
  return result;
}

}  // namespace

XrResult answer(const char* function, const std::function<XrResult()>& call) {
  const std::scoped_lock lock(runtime().mutex);
  try {
    fail_if_scripted(function);
    fail_if_lost(function);
    const XrResult result = call();
    const bool is_loss_pending = runtime().session && runtime().session->is_loss_pending;
    return result == XR_SUCCESS && is_loss_pending && may_tell_of_loss(function)
               ? XR_SESSION_LOSS_PENDING
               : result;
  } catch (const Refusal& refusal) {
    return refused(function, refusal.result(), refusal.what());
  } catch (const std::exception& error) {
    // Mostly a script that cannot be read, which whoever writes a test should see at once.
    std::cerr << fmt::format("{}: {}\n", function, error.what());
    return refused(function, XR_ERROR_RUNTIME_FAILURE, error.what());
  }
}

}  // namespace foveola::test::openxr
