// An application of OpenXR as small as can be, for tests of the runtime.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test {

/// An OpenGL context on the display of the environment, current for as long as it lives.
class GlxContext {
 public:
  GlxContext();
  ~GlxContext();
  GlxContext(const GlxContext&) = delete;
  GlxContext& operator=(const GlxContext&) = delete;

  XrGraphicsBindingOpenGLXlibKHR binding() const;

 private:
  Display* display_;
  GLXFBConfig config_ = nullptr;
  GLXPbuffer buffer_ = 0;
  GLXContext context_ = nullptr;
};

/// What the application got of a frame. Spaces without a name are located in LOCAL.
struct SeenFrame {
  XrResult wait_result = XR_SUCCESS;
  XrResult end_result = XR_SUCCESS;
  XrResult sync_result = XR_SUCCESS;
  XrFrameState state{XR_TYPE_FRAME_STATE};
  XrTime returned_at = 0;  ///< when xrWaitFrame did
  std::array<XrView, 2> views{XrView{XR_TYPE_VIEW}, XrView{XR_TYPE_VIEW}};
  XrViewStateFlags view_flags = 0;
  XrSpaceLocation head{XR_TYPE_SPACE_LOCATION};
  XrSpaceLocation stage{XR_TYPE_SPACE_LOCATION};
  XrSpaceLocation gaze_in_view{XR_TYPE_SPACE_LOCATION};
  XrTime gaze_sample_time = 0;
  bool is_gaze_active = false;
  XrActionStateBoolean select{XR_TYPE_ACTION_STATE_BOOLEAN};
};

/// What the application submits, for a test to spoil before it does.
struct Submission {
  XrTime display_time = 0;
  std::vector<XrCompositionLayerProjectionView> views;
  XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION};
};

/// Throws std::runtime_error for whatever fails that a test does not look at.
class Application {
 public:
  static std::vector<std::string> all_extensions();

  /// An instance, with these extensions.
  explicit Application(const std::vector<std::string>& extensions = all_extensions());
  ~Application();
  Application(const Application&) = delete;
  Application& operator=(const Application&) = delete;

  XrInstance instance() const { return instance_; }
  XrSystemId system() const { return system_; }
  XrSession session() const { return session_; }
  XrSessionState state() const { return state_; }
  XrSpace local() const { return local_; }
  XrSwapchain swapchain(std::size_t eye) const { return swapchains_[eye]; }

  /// A session with spaces, actions and swapchains, on a context that has to live longer.
  void start(const GlxContext& gl);
  /// Polls and runs frames until the session is focused: the next frame is the script's frame 0.
  void get_focused();
  /// All events that came, after which a session that is READY was begun, and one that is STOPPING
  /// ended.
  std::vector<XrEventDataBuffer> poll();
  /// A whole frame, in which the left eye sees red and the right one blue, and each a green row on
  /// top.
  SeenFrame frame(const std::function<void(Submission&)>& spoil = {});
  /// The same several times; the last one.
  SeenFrame frames(int count);
  void destroy_session();

  /// A function of an extension. Throws if the runtime does not have it.
  template <typename Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(function_of(name));
  }

  // Parts of frame().
  XrResult wait(SeenFrame& seen) const;
  void look(SeenFrame& seen) const;
  XrResult draw(std::size_t eye) const;
  XrResult submit(const SeenFrame& seen, const std::function<void(Submission&)>& spoil) const;

 private:
  PFN_xrVoidFunction function_of(const char* name) const;
  void make_spaces();
  void make_actions();
  void make_swapchains();
  XrAction make_action(const char* name, XrActionType type) const;
  void suggest(const char* profile, XrAction action, const char* source) const;
  XrSpaceLocation locate(XrSpace space, XrSpace base, XrTime time, void* next = nullptr) const;

  std::vector<std::string> extensions_;
  XrInstance instance_ = XR_NULL_HANDLE;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  XrSession session_ = XR_NULL_HANDLE;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool is_running_ = false;
  XrSpace local_ = XR_NULL_HANDLE;
  XrSpace view_ = XR_NULL_HANDLE;
  XrSpace stage_ = XR_NULL_HANDLE;
  XrSpace gaze_space_ = XR_NULL_HANDLE;
  XrActionSet action_set_ = XR_NULL_HANDLE;
  XrAction gaze_ = XR_NULL_HANDLE;
  XrAction select_ = XR_NULL_HANDLE;
  std::array<XrSwapchain, 2> swapchains_{};
  std::array<std::vector<XrSwapchainImageOpenGLKHR>, 2> images_;
};

/// Throws std::runtime_error if a call failed.
void require_success(XrResult result, const char* what);

}  // namespace foveola::test
