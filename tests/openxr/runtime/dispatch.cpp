// How the loader gets at the runtime's functions.
#include <string_view>

#include "tests/openxr/runtime/answer.h"
#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/negotiation.h"
#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

struct Entry {
  std::string_view name;
  PFN_xrVoidFunction function;
  const char* extension;   ///< that it belongs to, or null
  bool needs_no_instance;  ///< it may be called before there is one
};

template <FunctionName name, auto function>
Entry entry(const char* extension = nullptr, bool needs_no_instance = false) {
  return {name.text, reinterpret_cast<PFN_xrVoidFunction>(&Answered<name, function>::call),
          extension, needs_no_instance};
}

std::vector<Entry> entries_of_the_instance() {
  return {
      entry<"xrEnumerateApiLayerProperties", enumerate_api_layer_properties>(nullptr, true),
      entry<"xrEnumerateInstanceExtensionProperties", enumerate_instance_extension_properties>(
          nullptr, true),
      entry<"xrCreateInstance", create_instance>(nullptr, true),
      entry<"xrDestroyInstance", destroy_instance>(),
      entry<"xrGetInstanceProperties", get_instance_properties>(),
      entry<"xrPollEvent", poll_event>(),
      entry<"xrResultToString", result_to_string>(),
      entry<"xrStructureTypeToString", structure_type_to_string>(),
      entry<"xrStringToPath", string_to_path>(),
      entry<"xrPathToString", path_to_string>(),
      entry<"xrGetSystem", get_system>(),
      entry<"xrGetSystemProperties", get_system_properties>(),
      entry<"xrEnumerateEnvironmentBlendModes", enumerate_environment_blend_modes>(),
      entry<"xrEnumerateViewConfigurations", enumerate_view_configurations>(),
      entry<"xrGetViewConfigurationProperties", get_view_configuration_properties>(),
      entry<"xrEnumerateViewConfigurationViews", enumerate_view_configuration_views>(),
      entry<"xrGetOpenGLGraphicsRequirementsKHR", get_opengl_graphics_requirements>(
          XR_KHR_OPENGL_ENABLE_EXTENSION_NAME),
      entry<"xrConvertTimespecTimeToTimeKHR", convert_timespec_time_to_time>(
          XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME),
      entry<"xrConvertTimeToTimespecTimeKHR", convert_time_to_timespec_time>(
          XR_KHR_CONVERT_TIMESPEC_TIME_EXTENSION_NAME),
  };
}

std::vector<Entry> entries_of_the_session() {
  return {
      entry<"xrCreateSession", create_session>(),
      entry<"xrDestroySession", destroy_session>(),
      entry<"xrBeginSession", begin_session>(),
      entry<"xrEndSession", end_session>(),
      entry<"xrRequestExitSession", request_exit_session>(),
      entry<"xrEnumerateReferenceSpaces", enumerate_reference_spaces>(),
      entry<"xrCreateReferenceSpace", create_reference_space>(),
      entry<"xrGetReferenceSpaceBoundsRect", get_reference_space_bounds_rect>(),
      entry<"xrCreateActionSpace", create_action_space>(),
      entry<"xrLocateSpace", locate_space>(),
      entry<"xrDestroySpace", destroy_space>(),
      entry<"xrLocateViews", locate_views>(),
      entry<"xrEnumerateSwapchainFormats", enumerate_swapchain_formats>(),
      entry<"xrCreateSwapchain", create_swapchain>(),
      entry<"xrDestroySwapchain", destroy_swapchain>(),
      entry<"xrEnumerateSwapchainImages", enumerate_swapchain_images>(),
      entry<"xrAcquireSwapchainImage", acquire_swapchain_image>(),
      entry<"xrWaitSwapchainImage", wait_swapchain_image>(),
      entry<"xrReleaseSwapchainImage", release_swapchain_image>(),
      entry<"xrWaitFrame", wait_frame>(),
      entry<"xrBeginFrame", begin_frame>(),
      entry<"xrEndFrame", end_frame>(),
      entry<"xrGetVisibilityMaskKHR", get_visibility_mask>(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME),
  };
}

std::vector<Entry> entries_of_the_actions() {
  return {
      entry<"xrCreateActionSet", create_action_set>(),
      entry<"xrDestroyActionSet", destroy_action_set>(),
      entry<"xrCreateAction", create_action>(),
      entry<"xrDestroyAction", destroy_action>(),
      entry<"xrSuggestInteractionProfileBindings", suggest_interaction_profile_bindings>(),
      entry<"xrAttachSessionActionSets", attach_session_action_sets>(),
      entry<"xrGetCurrentInteractionProfile", get_current_interaction_profile>(),
      entry<"xrEnumerateBoundSourcesForAction", enumerate_bound_sources_for_action>(),
      entry<"xrGetInputSourceLocalizedName", get_input_source_localized_name>(),
      entry<"xrSyncActions", sync_actions>(),
      entry<"xrGetActionStateBoolean", get_action_state_boolean>(),
      entry<"xrGetActionStateFloat", get_action_state_float>(),
      entry<"xrGetActionStateVector2f", get_action_state_vector2f>(),
      entry<"xrGetActionStatePose", get_action_state_pose>(),
      entry<"xrApplyHapticFeedback", apply_haptic_feedback>(),
      entry<"xrStopHapticFeedback", stop_haptic_feedback>(),
  };
}

/// Not logged when it refuses: the loader asks for every function that it knows.
XrResult XRAPI_CALL get_instance_proc_addr(XrInstance instance, const char* name,
                                           PFN_xrVoidFunction* function) {
  if (name == nullptr || function == nullptr) {
    return XR_ERROR_VALIDATION_FAILURE;
  }
  *function = nullptr;
  const std::scoped_lock lock(runtime().mutex);
  if (instance != XR_NULL_HANDLE &&
      !(runtime().instance && runtime().instance->handle == instance)) {
    return XR_ERROR_HANDLE_INVALID;
  }
  if (std::string_view(name) == "xrGetInstanceProcAddr") {
    *function = reinterpret_cast<PFN_xrVoidFunction>(&get_instance_proc_addr);
    return XR_SUCCESS;
  }
  for (const std::vector<Entry>& chapter :
       {entries_of_the_instance(), entries_of_the_session(), entries_of_the_actions()}) {
    for (const Entry& entry : chapter) {
      if (entry.name == name) {
        const bool is_there = entry.extension == nullptr || is_enabled(entry.extension);
        if (instance == XR_NULL_HANDLE && !entry.needs_no_instance) {
          return XR_ERROR_HANDLE_INVALID;
        }
        *function = is_there ? entry.function : nullptr;
        return is_there ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED;
      }
    }
  }
  return XR_ERROR_FUNCTION_UNSUPPORTED;
}

bool is_understood(const LoaderInfo* info, const RuntimeRequest* request) {
  return info != nullptr && request != nullptr && info->type == NegotiatedStructure::loader_info &&
         info->structure_version == negotiated_structure_version &&
         info->structure_size == sizeof(LoaderInfo) &&
         request->type == NegotiatedStructure::runtime_request &&
         request->structure_version == negotiated_structure_version &&
         request->structure_size == sizeof(RuntimeRequest) &&
         info->min_interface_version <= runtime_interface_version &&
         info->max_interface_version >= runtime_interface_version &&
         info->min_api_version <= XR_MAKE_VERSION(1, 0, 0xffffffff) &&
         info->max_api_version >= XR_MAKE_VERSION(1, 0, 0);
}

}  // namespace
}  // namespace foveola::test::openxr

extern "C" __attribute__((visibility("default"))) XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const foveola::test::openxr::LoaderInfo* loader_info,
                                  foveola::test::openxr::RuntimeRequest* request) {
  using namespace foveola::test::openxr;
  if (!is_understood(loader_info, request)) {
    return XR_ERROR_INITIALIZATION_FAILED;
  }
  request->runtime_interface_version = runtime_interface_version;
  request->runtime_api_version = XR_MAKE_VERSION(1, 0, 20);
  request->get_instance_proc_addr = get_instance_proc_addr;
  return XR_SUCCESS;
}
