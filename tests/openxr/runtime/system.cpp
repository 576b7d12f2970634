#include "tests/openxr/runtime/system.h"

#include <fmt/format.h>
#include <glm/common.hpp>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/state.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {

void require_system(XrSystemId system) {
  require(system == the_system, XR_ERROR_SYSTEM_INVALID,
          "the system is not one that xrGetSystem gave");
}

void require_stereo(XrViewConfigurationType type) {
  require(type == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO,
          XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "there are views for two eyes only");
}

XrResult get_system(XrInstance instance, const XrSystemGetInfo* get_info, XrSystemId* system) {
  instance_of(instance);
  const XrSystemGetInfo& info = checked(get_info, XR_TYPE_SYSTEM_GET_INFO, "what system to get");
  require(info.formFactor == XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY, XR_ERROR_FORM_FACTOR_UNSUPPORTED,
          "there is a headset only");
  place_for(system, "the place for the system") = the_system;
  return XR_SUCCESS;
}

XrResult get_system_properties(XrInstance instance, XrSystemId system,
                               XrSystemProperties* properties) {
  instance_of(instance);
  require_system(system);
  XrSystemProperties& place =
      checked(properties, XR_TYPE_SYSTEM_PROPERTIES, "the place for the properties");
  const Script& script = runtime().script;
  place.systemId = the_system;
  place.vendorId = 0;
  put_text(script.system_name, place.systemName);
  place.graphicsProperties.maxSwapchainImageWidth = script.max_swapchain_px.width;
  place.graphicsProperties.maxSwapchainImageHeight = script.max_swapchain_px.height;
  place.graphicsProperties.maxLayerCount = XR_MIN_COMPOSITION_LAYERS_SUPPORTED;
  place.trackingProperties = {XR_TRUE, XR_TRUE};
  if (auto* const eyes = chained_result<XrSystemEyeGazeInteractionPropertiesEXT>(
          place.next, XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT)) {
    eyes->supportsEyeGazeInteraction = has_eye_tracker() ? XR_TRUE : XR_FALSE;
  }
#ifdef XR_EXT_user_presence
  if (auto* const presence = chained_result<XrSystemUserPresencePropertiesEXT>(
          place.next, XR_TYPE_SYSTEM_USER_PRESENCE_PROPERTIES_EXT)) {
    presence->supportsUserPresence =
        is_enabled(XR_EXT_USER_PRESENCE_EXTENSION_NAME) ? XR_TRUE : XR_FALSE;
  }
#endif
  return XR_SUCCESS;
}

bool has_eye_tracker() {
  return runtime().script.has_eye_tracker && is_enabled(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME);
}

XrResult enumerate_environment_blend_modes(XrInstance instance, XrSystemId system,
                                           XrViewConfigurationType type, std::uint32_t capacity,
                                           std::uint32_t* count, XrEnvironmentBlendMode* modes) {
  instance_of(instance);
  require_system(system);
  require_stereo(type);
  give_items({XR_ENVIRONMENT_BLEND_MODE_OPAQUE}, capacity, count, modes);
  return XR_SUCCESS;
}

XrResult enumerate_view_configurations(XrInstance instance, XrSystemId system,
                                       std::uint32_t capacity, std::uint32_t* count,
                                       XrViewConfigurationType* types) {
  instance_of(instance);
  require_system(system);
  give_items({XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO}, capacity, count, types);
  return XR_SUCCESS;
}

XrResult get_view_configuration_properties(XrInstance instance, XrSystemId system,
                                           XrViewConfigurationType type,
                                           XrViewConfigurationProperties* properties) {
  instance_of(instance);
  require_system(system);
  require_stereo(type);
  XrViewConfigurationProperties& place =
      checked(properties, XR_TYPE_VIEW_CONFIGURATION_PROPERTIES, "the place for the properties");
  place.viewConfigurationType = type;
  place.fovMutable = XR_FALSE;
  return XR_SUCCESS;
}

XrResult enumerate_view_configuration_views(XrInstance instance, XrSystemId system,
                                            XrViewConfigurationType type, std::uint32_t capacity,
                                            std::uint32_t* count, XrViewConfigurationView* views) {
  instance_of(instance);
  require_system(system);
  require_stereo(type);
  std::vector<XrViewConfigurationView> both;
  for (const ScriptedEye& eye : runtime().script.eyes) {
    both.push_back({XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, eye.recommended_px.width,
                    eye.max_px.width, eye.recommended_px.height, eye.max_px.height, 1, 1});
  }
  give_structures(both, XR_TYPE_VIEW_CONFIGURATION_VIEW, capacity, count, views);
  return XR_SUCCESS;
}

XrResult get_opengl_graphics_requirements(XrInstance instance, XrSystemId system,
                                          XrGraphicsRequirementsOpenGLKHR* requirements) {
  Instance& asking = instance_of(instance);
  require_system(system);
  XrGraphicsRequirementsOpenGLKHR& place = checked(
      requirements, XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR, "the place for the requirements");
  place.minApiVersionSupported = XR_MAKE_VERSION(3, 3, 0);
  place.maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  asking.are_graphics_requirements_known = true;
  return XR_SUCCESS;
}

XrResult get_visibility_mask(XrSession session, XrViewConfigurationType type, std::uint32_t view,
                             XrVisibilityMaskTypeKHR mask_type, XrVisibilityMaskKHR* mask) {
  session_of(session);
  require_stereo(type);
  require(view < runtime().script.eyes.size(), XR_ERROR_VALIDATION_FAILURE,
          "there is no such view");
  XrVisibilityMaskKHR& place = checked(mask, XR_TYPE_VISIBILITY_MASK_KHR, "the place for the mask");
  // The script tells what is hidden. Of the other kinds there is no mask: an empty one.
  const bool is_hidden_area = mask_type == XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR;
  const ScriptedEye& eye = runtime().script.eyes[view];
  const std::uint32_t vertex_capacity = place.vertexCapacityInput;
  const std::uint32_t index_capacity = place.indexCapacityInput;
  give_items(is_hidden_area ? eye.mask_vertices : std::vector<XrVector2f>(), vertex_capacity,
             &place.vertexCountOutput, place.vertices);
  give_items(is_hidden_area ? eye.mask_indices : std::vector<std::uint32_t>(), index_capacity,
             &place.indexCountOutput, place.indices);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
