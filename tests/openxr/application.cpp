#include "tests/openxr/application.h"

#include <algorithm>
#include <stdexcept>

namespace foveola::test {
namespace {

constexpr std::uint32_t width_px = 32;
constexpr std::uint32_t height_px = 36;
constexpr XrPosef nowhere_else = {{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

template <std::size_t size>
void put(const char* text, char (&out)[size]) {
  const std::string copied = text;
  copied.copy(out, size - 1);
}

bool includes(const std::vector<std::string>& texts, const char* text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

XrPath path(XrInstance instance, const char* text) {
  XrPath made = XR_NULL_PATH;
  require_success(xrStringToPath(instance, text, &made), text);
  return made;
}

}  // namespace

void require_success(XrResult result, const char* what) {
  if (XR_FAILED(result)) {
    throw std::runtime_error(std::string(what) + " failed: " + std::to_string(result));
  }
}

GlxContext::GlxContext() : display_(XOpenDisplay(nullptr)) {
  if (display_ == nullptr) {
    throw std::runtime_error("there is no display");
  }
  const int wanted[] = {GLX_DRAWABLE_TYPE, GLX_PBUFFER_BIT | GLX_WINDOW_BIT, GLX_RENDER_TYPE,
                        GLX_RGBA_BIT, 0};
  int count = 0;
  GLXFBConfig* const configs = glXChooseFBConfig(display_, DefaultScreen(display_), wanted, &count);
  if (count == 0) {
    throw std::runtime_error("the display has no OpenGL");
  }
  config_ = configs[0];
  XFree(configs);
  const int size[] = {GLX_PBUFFER_WIDTH, 1, GLX_PBUFFER_HEIGHT, 1, 0};
  buffer_ = glXCreatePbuffer(display_, config_, size);
  context_ = glXCreateNewContext(display_, config_, GLX_RGBA_TYPE, nullptr, 1);
  glXMakeContextCurrent(display_, buffer_, buffer_, context_);
}

GlxContext::~GlxContext() {
  glXMakeContextCurrent(display_, 0, 0, nullptr);
  glXDestroyContext(display_, context_);
  glXDestroyPbuffer(display_, buffer_);
  XCloseDisplay(display_);
}

XrGraphicsBindingOpenGLXlibKHR GlxContext::binding() const {
  int visual = 0;
  glXGetFBConfigAttrib(display_, config_, GLX_VISUAL_ID, &visual);
  return {XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR,
          nullptr,
          display_,
          static_cast<std::uint32_t>(visual),
          config_,
          buffer_,
          context_};
}

std::vector<std::string> Application::all_extensions() {
  return {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME,
          XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME, XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,
#ifdef XR_EXT_user_presence
          XR_EXT_USER_PRESENCE_EXTENSION_NAME
#endif
  };
}

Application::Application(const std::vector<std::string>& extensions) : extensions_(extensions) {
  std::vector<const char*> names;
  for (const std::string& extension : extensions_) {
    names.push_back(extension.c_str());
  }
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  put("small application", info.applicationInfo.applicationName);
  put("no engine", info.applicationInfo.engineName);
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
  info.enabledExtensionNames = names.data();
  require_success(xrCreateInstance(&info, &instance_), "xrCreateInstance");
  XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO};
  wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  require_success(xrGetSystem(instance_, &wanted, &system_), "xrGetSystem");
}

Application::~Application() { xrDestroyInstance(instance_); }

PFN_xrVoidFunction Application::function_of(const char* name) const {
  PFN_xrVoidFunction found = nullptr;
  require_success(xrGetInstanceProcAddr(instance_, name, &found), name);
  return found;
}

void Application::start(const GlxContext& gl) {
  XrGraphicsRequirementsOpenGLKHR requirements{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
  require_success(function<PFN_xrGetOpenGLGraphicsRequirementsKHR>(
                      "xrGetOpenGLGraphicsRequirementsKHR")(instance_, system_, &requirements),
                  "xrGetOpenGLGraphicsRequirementsKHR");
  const XrGraphicsBindingOpenGLXlibKHR binding = gl.binding();
  XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO};
  info.next = &binding;
  info.systemId = system_;
  require_success(xrCreateSession(instance_, &info, &session_), "xrCreateSession");
  make_spaces();
  make_actions();
  make_swapchains();
}

void Application::make_spaces() {
  XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
  info.poseInReferenceSpace = nowhere_else;
  for (const auto& [type, space] : {std::pair{XR_REFERENCE_SPACE_TYPE_LOCAL, &local_},
                                    std::pair{XR_REFERENCE_SPACE_TYPE_VIEW, &view_},
                                    std::pair{XR_REFERENCE_SPACE_TYPE_STAGE, &stage_}}) {
    info.referenceSpaceType = type;
    require_success(xrCreateReferenceSpace(session_, &info, space), "xrCreateReferenceSpace");
  }
}

XrAction Application::make_action(const char* name, XrActionType type) const {
  XrActionCreateInfo info{XR_TYPE_ACTION_CREATE_INFO};
  put(name, info.actionName);
  put(name, info.localizedActionName);
  info.actionType = type;
  XrAction made = XR_NULL_HANDLE;
  require_success(xrCreateAction(action_set_, &info, &made), "xrCreateAction");
  return made;
}

void Application::suggest(const char* profile, XrAction action, const char* source) const {
  const XrActionSuggestedBinding binding{action, path(instance_, source)};
  XrInteractionProfileSuggestedBinding info{XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING};
  info.interactionProfile = path(instance_, profile);
  info.countSuggestedBindings = 1;
  info.suggestedBindings = &binding;
  require_success(xrSuggestInteractionProfileBindings(instance_, &info), profile);
}

void Application::make_actions() {
  XrActionSetCreateInfo set{XR_TYPE_ACTION_SET_CREATE_INFO};
  put("all", set.actionSetName);
  put("All", set.localizedActionSetName);
  require_success(xrCreateActionSet(instance_, &set, &action_set_), "xrCreateActionSet");
  select_ = make_action("select", XR_ACTION_TYPE_BOOLEAN_INPUT);
  suggest("/interaction_profiles/khr/simple_controller", select_,
          "/user/hand/right/input/select/click");
  suggest("/interaction_profiles/microsoft/xbox_controller", select_,
          "/user/gamepad/input/a/click");
  suggest("/interaction_profiles/oculus/touch_controller", select_,
          "/user/hand/right/input/trigger/value");
  gaze_ = make_action("gaze", XR_ACTION_TYPE_POSE_INPUT);
  if (includes(extensions_, XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME)) {
    suggest("/interaction_profiles/ext/eye_gaze_interaction", gaze_,
            "/user/eyes_ext/input/gaze_ext/pose");
  }
  XrActionSpaceCreateInfo space{XR_TYPE_ACTION_SPACE_CREATE_INFO};
  space.action = gaze_;
  space.poseInActionSpace = nowhere_else;
  require_success(xrCreateActionSpace(session_, &space, &gaze_space_), "xrCreateActionSpace");
  XrSessionActionSetsAttachInfo attached{XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO};
  attached.countActionSets = 1;
  attached.actionSets = &action_set_;
  require_success(xrAttachSessionActionSets(session_, &attached), "xrAttachSessionActionSets");
}

void Application::make_swapchains() {
  XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
  info.format = GL_SRGB8_ALPHA8;
  info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
  info.width = width_px;
  info.height = height_px;
  for (std::size_t eye = 0; eye < swapchains_.size(); ++eye) {
    require_success(xrCreateSwapchain(session_, &info, &swapchains_[eye]), "xrCreateSwapchain");
    std::uint32_t count = 0;
    require_success(xrEnumerateSwapchainImages(swapchains_[eye], 0, &count, nullptr),
                    "xrEnumerateSwapchainImages");
    images_[eye].assign(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR});
    require_success(xrEnumerateSwapchainImages(
                        swapchains_[eye], count, &count,
                        reinterpret_cast<XrSwapchainImageBaseHeader*>(images_[eye].data())),
                    "xrEnumerateSwapchainImages");
  }
}

std::vector<XrEventDataBuffer> Application::poll() {
  std::vector<XrEventDataBuffer> events;
  for (XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
       xrPollEvent(instance_, &event) == XR_SUCCESS; event = {XR_TYPE_EVENT_DATA_BUFFER}) {
    events.push_back(event);
    if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) {
      state_ = reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state;
    }
    if (state_ == XR_SESSION_STATE_READY && !is_running_) {
      XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO};
      info.primaryViewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
      require_success(xrBeginSession(session_, &info), "xrBeginSession");
      is_running_ = true;
    }
    if (state_ == XR_SESSION_STATE_STOPPING && is_running_) {
      require_success(xrEndSession(session_), "xrEndSession");
      is_running_ = false;
    }
  }
  return events;
}

void Application::get_focused() {
  for (poll(); state_ != XR_SESSION_STATE_FOCUSED; poll()) {
    frame();
  }
}

XrSpaceLocation Application::locate(XrSpace space, XrSpace base, XrTime time, void* next) const {
  XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
  location.next = next;
  require_success(xrLocateSpace(space, base, time, &location), "xrLocateSpace");
  location.next = nullptr;
  return location;
}

XrResult Application::wait(SeenFrame& seen) const {
  seen.wait_result = xrWaitFrame(session_, nullptr, &seen.state);
  if (includes(extensions_, XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME)) {
    timespec present{};
    ::clock_gettime(CLOCK_MONOTONIC, &present);
    function<PFN_xrConvertTimespecTimeToTimeKHR>("xrConvertTimespecTimeToTimeKHR")(
        instance_, &present, &seen.returned_at);
  }
  return seen.wait_result;
}

void Application::look(SeenFrame& seen) const {
  const XrActiveActionSet active{action_set_, XR_NULL_PATH};
  XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO};
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  seen.sync_result = xrSyncActions(session_, &sync);
  XrActionStateGetInfo get{XR_TYPE_ACTION_STATE_GET_INFO};
  get.action = select_;
  xrGetActionStateBoolean(session_, &get, &seen.select);
  get.action = gaze_;
  XrActionStatePose gaze{XR_TYPE_ACTION_STATE_POSE};
  xrGetActionStatePose(session_, &get, &gaze);
  seen.is_gaze_active = gaze.isActive != XR_FALSE;
  const XrTime time = seen.state.predictedDisplayTime;
  XrEyeGazeSampleTimeEXT sample{XR_TYPE_EYE_GAZE_SAMPLE_TIME_EXT};
  const bool has_gaze = includes(extensions_, XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME);
  seen.gaze_in_view = locate(gaze_space_, view_, time, has_gaze ? &sample : nullptr);
  seen.gaze_sample_time = sample.time;
  seen.head = locate(view_, local_, time);
  seen.stage = locate(stage_, local_, time);
  XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO};
  info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  info.displayTime = time;
  info.space = local_;
  XrViewState state{XR_TYPE_VIEW_STATE};
  std::uint32_t count = 0;
  require_success(xrLocateViews(session_, &info, &state, 2, &count, seen.views.data()),
                  "xrLocateViews");
  seen.view_flags = state.viewStateFlags;
}

XrResult Application::draw(std::size_t eye) const {
  std::uint32_t index = 0;
  require_success(xrAcquireSwapchainImage(swapchains_[eye], nullptr, &index),
                  "xrAcquireSwapchainImage");
  XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
  wait.timeout = XR_INFINITE_DURATION;
  require_success(xrWaitSwapchainImage(swapchains_[eye], &wait), "xrWaitSwapchainImage");
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                         images_[eye][index].image, 0);
  glClearColor(eye == 0 ? 1.0F : 0.0F, 0.0F, eye == 0 ? 0.0F : 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, height_px - 1, width_px, 1);
  glClearColor(0.0F, 1.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glDeleteFramebuffers(1, &framebuffer);
  return xrReleaseSwapchainImage(swapchains_[eye], nullptr);
}

XrResult Application::submit(const SeenFrame& seen,
                             const std::function<void(Submission&)>& spoil) const {
  Submission submission;
  submission.display_time = seen.state.predictedDisplayTime;
  submission.layer.space = local_;
  for (std::size_t eye = 0; eye < swapchains_.size(); ++eye) {
    XrCompositionLayerProjectionView view{XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
    view.pose = seen.views[eye].pose;
    view.fov = seen.views[eye].fov;
    view.subImage = {swapchains_[eye], {{0, 0}, {width_px, height_px}}, 0};
    submission.views.push_back(view);
  }
  if (spoil) {
    spoil(submission);
  }
  submission.layer.viewCount = static_cast<std::uint32_t>(submission.views.size());
  submission.layer.views = submission.views.data();
  const auto* const layer =
      reinterpret_cast<const XrCompositionLayerBaseHeader*>(&submission.layer);
  XrFrameEndInfo end{XR_TYPE_FRAME_END_INFO};
  end.displayTime = submission.display_time;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  end.layerCount = seen.state.shouldRender == XR_FALSE ? 0 : 1;
  end.layers = &layer;
  return xrEndFrame(session_, &end);
}

SeenFrame Application::frame(const std::function<void(Submission&)>& spoil) {
  SeenFrame seen;
  require_success(wait(seen), "xrWaitFrame");
  require_success(xrBeginFrame(session_, nullptr), "xrBeginFrame");
  look(seen);
  if (seen.state.shouldRender != XR_FALSE) {
    require_success(draw(0), "xrReleaseSwapchainImage");
    require_success(draw(1), "xrReleaseSwapchainImage");
  }
  seen.end_result = submit(seen, spoil);
  return seen;
}

SeenFrame Application::frames(int count) {
  SeenFrame seen;
  for (int i = 0; i < count; ++i) {
    seen = frame();
  }
  return seen;
}

void Application::destroy_session() {
  require_success(xrDestroySession(session_), "xrDestroySession");
  session_ = XR_NULL_HANDLE;
  is_running_ = false;
}

}  // namespace foveola::test
