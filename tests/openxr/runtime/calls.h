// OpenXR's functions, as this runtime carries them out. They throw a Refusal for whatever they do
// not do; answer.h makes results of that.
#pragma once

#include <type_traits>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// What OpenXR declares a pointer to.
template <typename Pointer>
using Call = std::remove_pointer_t<Pointer>;

// instance.cpp: what an application may have of this runtime.
Call<PFN_xrEnumerateApiLayerProperties> enumerate_api_layer_properties;
Call<PFN_xrEnumerateInstanceExtensionProperties> enumerate_instance_extension_properties;
Call<PFN_xrCreateInstance> create_instance;
Call<PFN_xrDestroyInstance> destroy_instance;
Call<PFN_xrGetInstanceProperties> get_instance_properties;
Call<PFN_xrPollEvent> poll_event;
Call<PFN_xrResultToString> result_to_string;
Call<PFN_xrStructureTypeToString> structure_type_to_string;
Call<PFN_xrStringToPath> string_to_path;
Call<PFN_xrPathToString> path_to_string;

// system.cpp: the headset.
Call<PFN_xrGetSystem> get_system;
Call<PFN_xrGetSystemProperties> get_system_properties;
Call<PFN_xrEnumerateEnvironmentBlendModes> enumerate_environment_blend_modes;
Call<PFN_xrEnumerateViewConfigurations> enumerate_view_configurations;
Call<PFN_xrGetViewConfigurationProperties> get_view_configuration_properties;
Call<PFN_xrEnumerateViewConfigurationViews> enumerate_view_configuration_views;
Call<PFN_xrGetOpenGLGraphicsRequirementsKHR> get_opengl_graphics_requirements;
Call<PFN_xrGetVisibilityMaskKHR> get_visibility_mask;

// session.cpp: from its creation to its end.
Call<PFN_xrCreateSession> create_session;
Call<PFN_xrDestroySession> destroy_session;
Call<PFN_xrBeginSession> begin_session;
Call<PFN_xrEndSession> end_session;
Call<PFN_xrRequestExitSession> request_exit_session;

// spaces.cpp and views.cpp: where things are.
Call<PFN_xrEnumerateReferenceSpaces> enumerate_reference_spaces;
Call<PFN_xrCreateReferenceSpace> create_reference_space;
Call<PFN_xrGetReferenceSpaceBoundsRect> get_reference_space_bounds_rect;
Call<PFN_xrCreateActionSpace> create_action_space;
Call<PFN_xrLocateSpace> locate_space;
Call<PFN_xrDestroySpace> destroy_space;
Call<PFN_xrLocateViews> locate_views;

// swapchains.cpp: the images that are drawn on.
Call<PFN_xrEnumerateSwapchainFormats> enumerate_swapchain_formats;
Call<PFN_xrCreateSwapchain> create_swapchain;
Call<PFN_xrDestroySwapchain> destroy_swapchain;
Call<PFN_xrEnumerateSwapchainImages> enumerate_swapchain_images;
Call<PFN_xrAcquireSwapchainImage> acquire_swapchain_image;
Call<PFN_xrWaitSwapchainImage> wait_swapchain_image;
Call<PFN_xrReleaseSwapchainImage> release_swapchain_image;

// frames.cpp: when they are shown.
Call<PFN_xrWaitFrame> wait_frame;
Call<PFN_xrBeginFrame> begin_frame;
Call<PFN_xrEndFrame> end_frame;

// actions.cpp, bindings.cpp and action_states.cpp: what the user does.
Call<PFN_xrCreateActionSet> create_action_set;
Call<PFN_xrDestroyActionSet> destroy_action_set;
Call<PFN_xrCreateAction> create_action;
Call<PFN_xrDestroyAction> destroy_action;
Call<PFN_xrSuggestInteractionProfileBindings> suggest_interaction_profile_bindings;
Call<PFN_xrAttachSessionActionSets> attach_session_action_sets;
Call<PFN_xrGetCurrentInteractionProfile> get_current_interaction_profile;
Call<PFN_xrEnumerateBoundSourcesForAction> enumerate_bound_sources_for_action;
Call<PFN_xrGetInputSourceLocalizedName> get_input_source_localized_name;
Call<PFN_xrSyncActions> sync_actions;
Call<PFN_xrGetActionStateBoolean> get_action_state_boolean;
Call<PFN_xrGetActionStateFloat> get_action_state_float;
Call<PFN_xrGetActionStateVector2f> get_action_state_vector2f;
Call<PFN_xrGetActionStatePose> get_action_state_pose;
Call<PFN_xrApplyHapticFeedback> apply_haptic_feedback;
Call<PFN_xrStopHapticFeedback> stop_haptic_feedback;

// times.cpp: the runtime's clock and the system's.
Call<PFN_xrConvertTimespecTimeToTimeKHR> convert_timespec_time_to_time;
Call<PFN_xrConvertTimeToTimespecTimeKHR> convert_time_to_timespec_time;

}  // namespace foveola::test::openxr
