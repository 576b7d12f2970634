#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

constexpr XrSystemId the_system = 1;

void read_environment() {
  const char* const folder = std::getenv("FOVEOLA_OPENXR_FOLDER");
  if (runtime().folder != folder) {
    runtime().folder = folder;
    runtime().sessions = 0;
  }
  runtime().script = read_script(runtime().folder / "script.json");
}

}  // namespace

Runtime& runtime() {
  static Runtime only;
  return only;
}

const std::string& path_text(XrPath path) { return runtime().instance->paths.at(path - 1); }

bool is_enabled(const char* extension) {
  return runtime().instance->extensions.contains(extension);
}

void write_log(const nlohmann::json& line) {
  // One string, which is written by one call: lines of several processes stay whole.
  std::ofstream(runtime().folder / "log", std::ios::app) << line.dump() + '\n' << std::flush;
}

XrResult EnumerateInstanceExtensionProperties(const char* /*layer*/, std::uint32_t capacity,
                                              std::uint32_t* count,
                                              XrExtensionProperties* properties) {
  read_environment();
  std::vector<XrExtensionProperties> offered;
  for (const std::string& name : runtime().script.extensions) {
    offered.push_back({XR_TYPE_EXTENSION_PROPERTIES});
    put_text(name, offered.back().extensionName);
    offered.back().extensionVersion = 1;
  }
  give_items(offered, capacity, count, properties);
  return XR_SUCCESS;
}

XrResult CreateInstance(const XrInstanceCreateInfo* info, XrInstance* instance) {
  require(!runtime().instance, XR_ERROR_LIMIT_REACHED, "there is an instance already");
  read_environment();
  const XrVersion version = info->applicationInfo.apiVersion;
  require(XR_VERSION_MAJOR(version) == 1 && XR_VERSION_MINOR(version) == 0,
          XR_ERROR_API_VERSION_UNSUPPORTED, "this runtime's version is 1.0");
  Instance made;
  for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
    const std::string name = info->enabledExtensionNames[i];
    const std::vector<std::string>& offered = runtime().script.extensions;
    require(std::ranges::find(offered, name) != offered.end(), XR_ERROR_EXTENSION_NOT_PRESENT,
            name + " is not offered");
    made.extensions.insert(name);
  }
  *instance = handle_of<XrInstance>(runtime().instance.emplace(std::move(made)));
  return XR_SUCCESS;
}

XrResult DestroyInstance(XrInstance /*instance*/) {
  runtime().session.reset();
  runtime().instance.reset();
  return XR_SUCCESS;
}

XrResult GetInstanceProperties(XrInstance /*instance*/, XrInstanceProperties* properties) {
  properties->runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  put_text("Foveola's test runtime", properties->runtimeName);
  return XR_SUCCESS;
}

XrResult PollEvent(XrInstance /*instance*/, XrEventDataBuffer* event) {
  std::deque<XrEventDataBuffer>& events = runtime().instance->events;
  if (events.empty()) {
    return XR_EVENT_UNAVAILABLE;
  }
  *event = events.front();
  events.pop_front();
  return XR_SUCCESS;
}

XrResult ResultToString(XrInstance /*instance*/, XrResult value, char* buffer) {
  put_text(result_name(value), reinterpret_cast<char(&)[XR_MAX_RESULT_STRING_SIZE]>(*buffer));
  return XR_SUCCESS;
}

XrResult StringToPath(XrInstance /*instance*/, const char* text, XrPath* path) {
  std::vector<std::string>& paths = runtime().instance->paths;
  const auto found = std::ranges::find(paths, text);
  *path = static_cast<XrPath>(found - paths.begin()) + 1;
  if (found == paths.end()) {
    paths.emplace_back(text);
  }
  return XR_SUCCESS;
}

XrResult GetSystem(XrInstance /*instance*/, const XrSystemGetInfo* info, XrSystemId* system) {
  require(info->formFactor == XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY, XR_ERROR_FORM_FACTOR_UNSUPPORTED,
          "there is only a headset");
  *system = the_system;
  return XR_SUCCESS;
}

XrResult GetSystemProperties(XrInstance /*instance*/, XrSystemId /*system*/,
                             XrSystemProperties* properties) {
  properties->systemId = the_system;
  put_text(runtime().script.system_name, properties->systemName);
  properties->trackingProperties = {XR_TRUE, XR_TRUE};
  if (auto* const eyes = chained<XrSystemEyeGazeInteractionPropertiesEXT>(
          properties->next, XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT)) {
    eyes->supportsEyeGazeInteraction = XR_TRUE;
  }
  return XR_SUCCESS;
}

XrResult EnumerateViewConfigurationViews(XrInstance /*instance*/, XrSystemId /*system*/,
                                         XrViewConfigurationType /*type*/, std::uint32_t capacity,
                                         std::uint32_t* count, XrViewConfigurationView* views) {
  std::vector<XrViewConfigurationView> both;
  for (const ScriptedEye& eye : runtime().script.eyes) {
    both.push_back({XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, eye.width_px, 2 * eye.width_px,
                    eye.height_px, 2 * eye.height_px, 1, 1});
  }
  give_items(both, capacity, count, views);
  return XR_SUCCESS;
}

XrResult GetOpenGLGraphicsRequirementsKHR(XrInstance /*instance*/, XrSystemId /*system*/,
                                          XrGraphicsRequirementsOpenGLKHR* requirements) {
  requirements->minApiVersionSupported = XR_MAKE_VERSION(3, 3, 0);
  requirements->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  runtime().instance->are_graphics_requirements_known = true;
  return XR_SUCCESS;
}

XrResult GetVisibilityMaskKHR(XrSession /*session*/, XrViewConfigurationType /*type*/,
                              std::uint32_t view, XrVisibilityMaskTypeKHR mask_type,
                              XrVisibilityMaskKHR* mask) {
  require(mask_type == XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR,
          XR_ERROR_VALIDATION_FAILURE, "the script tells only what is hidden");
  const ScriptedEye& eye = runtime().script.eyes.at(view);
  give_items(eye.mask_vertices, mask->vertexCapacityInput, &mask->vertexCountOutput,
             mask->vertices);
  give_items(eye.mask_indices, mask->indexCapacityInput, &mask->indexCountOutput, mask->indices);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
