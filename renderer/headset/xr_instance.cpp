#include "renderer/headset/xr_instance.h"

#include <algorithm>
#include <cstdint>
#include <ctime>

#define XR_USE_TIMESPEC
#include <fmt/format.h>
#include <openxr/openxr_platform.h>

#include "renderer/base/error.h"
#include "renderer/base/transformed.h"

namespace foveola {
namespace {

constexpr const char* opengl_extension = "XR_KHR_opengl_enable";
constexpr const char* remedy_of_faults = "look at what the headset's runtime says, or restart it";

/// Extensions without which there is no display.
constexpr std::array required_extensions = {opengl_extension,
                                            XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME};
constexpr std::array optional_extensions = {XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME,
                                            XR_KHR_VISIBILITY_MASK_EXTENSION_NAME,
#ifdef XR_EXT_user_presence
                                            XR_EXT_USER_PRESENCE_EXTENSION_NAME
#endif
};

std::vector<std::string> offered_extensions(const XrLoader& loader) {
  const auto enumerate = reinterpret_cast<PFN_xrEnumerateInstanceExtensionProperties>(
      loader.find(XR_NULL_HANDLE, "xrEnumerateInstanceExtensionProperties"));
  std::uint32_t count = 0;
  if (enumerate == nullptr || XR_FAILED(enumerate(nullptr, 0, &count, nullptr))) {
    throw Error(
        "headset", "no runtime of OpenXR answers",
        "start the headset's runtime, and name it in XR_RUNTIME_JSON or active_runtime.json");
  }
  std::vector<XrExtensionProperties> properties(count, {XR_TYPE_EXTENSION_PROPERTIES});
  enumerate(nullptr, count, &count, properties.data());
  return transformed<std::string>(properties, &XrExtensionProperties::extensionName);
}

bool includes(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

std::vector<std::string> wanted_extensions(const XrLoader& loader) {
  const std::vector<std::string> offered = offered_extensions(loader);
  std::vector<std::string> wanted;
  for (const char* name : required_extensions) {
    if (!includes(offered, name)) {
      throw Error("headset", fmt::format("the runtime of OpenXR does not offer {}", name),
                  "use one that draws with OpenGL on X, such as Monado or SteamVR");
    }
    wanted.emplace_back(name);
  }
  for (const char* name : optional_extensions) {
    if (includes(offered, name)) {
      wanted.emplace_back(name);
    }
  }
  return wanted;
}

}  // namespace

XrInstanceOwner::XrInstanceOwner() : extensions_(wanted_extensions(loader_)) {
  make_instance();
  try {
    xr_ = loader_.functions_of(instance_);
    to_xr_time_ = loader_.find(instance_, "xrConvertTimespecTimeToTimeKHR");
    to_timespec_ = loader_.find(instance_, "xrConvertTimeToTimespecTimeKHR");
    find_headset();
    read_properties();
    read_eyes();
  } catch (...) {
    function<PFN_xrDestroyInstance>("xrDestroyInstance")(instance_);
    throw;
  }
}

XrInstanceOwner::~XrInstanceOwner() { xr_.DestroyInstance(instance_); }

void XrInstanceOwner::make_instance() {
  const std::vector<const char*> names =
      transformed(extensions_, [&](const std::string& name) { return name.c_str(); });
  XrInstanceCreateInfo info{XR_TYPE_INSTANCE_CREATE_INFO};
  put_text("Foveola", info.applicationInfo.applicationName);
  info.applicationInfo.apiVersion = XR_MAKE_VERSION(1, 0, 0);
  info.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
  info.enabledExtensionNames = names.data();
  const auto create = function<PFN_xrCreateInstance>("xrCreateInstance");
  const XrResult made = create(&info, &instance_);
  if (XR_FAILED(made)) {
    throw Error(
        "headset",
        fmt::format("the runtime of OpenXR does not start (error {})", static_cast<int>(made)),
        "start the headset's runtime first");
  }
}

void XrInstanceOwner::find_headset() {
  XrSystemGetInfo wanted{XR_TYPE_SYSTEM_GET_INFO};
  wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
  const XrResult found = xr_.GetSystem(instance_, &wanted, &system_);
  if (found == XR_ERROR_FORM_FACTOR_UNAVAILABLE) {
    throw Error("headset", "the runtime's headset is not there", "connect it and switch it on");
  }
  require(found, "xrGetSystem");
}

void XrInstanceOwner::read_properties() {
  XrInstanceProperties runtime{XR_TYPE_INSTANCE_PROPERTIES};
  require(xr_.GetInstanceProperties(instance_, &runtime), "xrGetInstanceProperties");
  runtime_ = fmt::format(
      "{} {}.{}.{}", runtime.runtimeName, XR_VERSION_MAJOR(runtime.runtimeVersion),
      XR_VERSION_MINOR(runtime.runtimeVersion), XR_VERSION_PATCH(runtime.runtimeVersion));
  XrSystemEyeGazeInteractionPropertiesEXT eyes{XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT};
  XrSystemProperties headset{XR_TYPE_SYSTEM_PROPERTIES};
  const bool may_have_eyes = is_enabled(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME);
  headset.next = may_have_eyes ? &eyes : nullptr;
  require(xr_.GetSystemProperties(instance_, system_, &headset), "xrGetSystemProperties");
  headset_ = headset.systemName;
  has_eye_tracker_ = may_have_eyes && eyes.supportsEyeGazeInteraction != XR_FALSE;
}

void XrInstanceOwner::read_eyes() {
  std::uint32_t count = 0;
  std::array<XrViewConfigurationView, 2> views;
  views.fill({XR_TYPE_VIEW_CONFIGURATION_VIEW});
  require(
      xr_.EnumerateViewConfigurationViews(
          instance_, system_, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count, views.data()),
      "xrEnumerateViewConfigurationViews");
  for (std::size_t eye = 0; eye < eye_px_.size(); ++eye) {
    eye_px_[eye] = {static_cast<int>(views[eye].recommendedImageRectWidth),
                    static_cast<int>(views[eye].recommendedImageRectHeight)};
  }
}

bool XrInstanceOwner::is_enabled(const char* extension) const {
  return includes(extensions_, extension);
}

XrTime XrInstanceOwner::xr_time(Nanoseconds steady) const {
  constexpr std::int64_t per_second = 1'000'000'000;
  const std::timespec time{.tv_sec = steady.count() / per_second,
                           .tv_nsec = steady.count() % per_second};
  XrTime converted = 0;
  require(reinterpret_cast<PFN_xrConvertTimespecTimeToTimeKHR>(to_xr_time_)(instance_, &time,
                                                                            &converted),
          "xrConvertTimespecTimeToTimeKHR");
  return converted;
}

Nanoseconds XrInstanceOwner::steady_time(XrTime time) const {
  std::timespec converted{};
  require(reinterpret_cast<PFN_xrConvertTimeToTimespecTimeKHR>(to_timespec_)(instance_, time,
                                                                             &converted),
          "xrConvertTimeToTimespecTimeKHR");
  return std::chrono::seconds(converted.tv_sec) + Nanoseconds(converted.tv_nsec);
}

XrPath XrInstanceOwner::path(const char* text) const {
  XrPath made = XR_NULL_PATH;
  require(xr_.StringToPath(instance_, text, &made), "xrStringToPath");
  return made;
}

void XrInstanceOwner::require(XrResult result, const char* call) const {
  if (result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST ||
      result == XR_SESSION_LOSS_PENDING) {
    throw HeadsetLost();
  }
  if (XR_FAILED(result)) {
    char name[XR_MAX_RESULT_STRING_SIZE] = {};
    xr_.ResultToString(instance_, result, name);
    throw Error("headset", fmt::format("{} was answered with {}", call, name), remedy_of_faults);
  }
}

}  // namespace foveola
