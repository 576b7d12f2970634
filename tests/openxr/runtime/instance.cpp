#include <algorithm>
#include <bit>
#include <string_view>

#include <fmt/format.h>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/extensions.h"
#include "tests/openxr/runtime/names.h"
#include "tests/openxr/runtime/session_states.h"
#include "tests/openxr/runtime/state.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {
namespace {

/// Those that the script offers and the runtime knows.
std::vector<XrExtensionProperties> offered_extensions() {
  std::vector<XrExtensionProperties> offered;
  for (const Extension& extension : extensions) {
    const std::vector<std::string>& scripted = runtime().script.extensions;
    if (std::find(scripted.begin(), scripted.end(), extension.name) != scripted.end()) {
      XrExtensionProperties properties{XR_TYPE_EXTENSION_PROPERTIES};
      put_text(extension.name, properties.extensionName);
      properties.extensionVersion = extension.version;
      offered.push_back(properties);
    }
  }
  return offered;
}

std::set<std::string> asked_extensions(const XrInstanceCreateInfo& info) {
  const std::vector<XrExtensionProperties> offered = offered_extensions();
  std::set<std::string> asked;
  for (std::uint32_t i = 0; i < info.enabledExtensionCount; ++i) {
    const std::string name = info.enabledExtensionNames[i];
    if (std::none_of(offered.begin(), offered.end(),
                     [&](const auto& extension) { return name == extension.extensionName; })) {
      throw Refusal(XR_ERROR_EXTENSION_NOT_PRESENT, name + " is not offered");
    }
    asked.insert(name);
  }
  return asked;
}

void check_application(const XrApplicationInfo& application) {
  require(application.applicationName[0] != '\0', XR_ERROR_NAME_INVALID,
          "the application has no name");
  require(XR_VERSION_MAJOR(application.apiVersion) == 1 &&
              XR_VERSION_MINOR(application.apiVersion) == 0,
          XR_ERROR_API_VERSION_UNSUPPORTED,
          "the application asks for another version than 1.0, which is this runtime's");
}

void log_instance(const XrApplicationInfo& application, const std::set<std::string>& extensions) {
  runtime().log.write(
      {{"kind", "instance"},
       {"application", application.applicationName},
       {"engine", application.engineName},
       {"api_version", fmt::format("{}.{}.{}", XR_VERSION_MAJOR(application.apiVersion),
                                   XR_VERSION_MINOR(application.apiVersion),
                                   XR_VERSION_PATCH(application.apiVersion))},
       {"extensions", extensions}});
}

/// Of levels of small letters, digits, '-', '_' and '.', each behind a '/'.
bool is_well_formed(std::string_view path) {
  if (path.size() >= XR_MAX_PATH_LENGTH || path.substr(0, 1) != "/" || path.back() == '/') {
    return false;
  }
  const bool is_of_known_letters = std::all_of(path.begin(), path.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') ||
           std::string_view("-_./").find(letter) != std::string_view::npos;
  });
  std::string_view rest = path;
  while (!rest.empty()) {
    rest.remove_prefix(1);
    const std::string_view level = rest.substr(0, rest.find('/'));
    if (level.find_first_not_of('.') == std::string_view::npos) {
      return false;
    }
    rest.remove_prefix(level.size());
  }
  return is_of_known_letters;
}

}  // namespace

XrResult enumerate_api_layer_properties(std::uint32_t capacity, std::uint32_t* count,
                                        XrApiLayerProperties* layers) {
  give_structures<XrApiLayerProperties>({}, XR_TYPE_API_LAYER_PROPERTIES, capacity, count, layers);
  return XR_SUCCESS;
}

XrResult enumerate_instance_extension_properties(const char* layer, std::uint32_t capacity,
                                                 std::uint32_t* count,
                                                 XrExtensionProperties* properties) {
  require(layer == nullptr, XR_ERROR_API_LAYER_NOT_PRESENT, "a runtime has no layers");
  if (!runtime().instance) {
    read_environment();
  }
  give_structures(offered_extensions(), XR_TYPE_EXTENSION_PROPERTIES, capacity, count, properties);
  return XR_SUCCESS;
}

XrResult create_instance(const XrInstanceCreateInfo* create_info, XrInstance* instance) {
  const XrInstanceCreateInfo& info =
      checked(create_info, XR_TYPE_INSTANCE_CREATE_INFO, "the information for the instance");
  XrInstance& place = place_for(instance, "the place for the instance");
  require(!runtime().instance, XR_ERROR_LIMIT_REACHED, "there is an instance already");
  read_environment();
  require(info.createFlags == 0, XR_ERROR_VALIDATION_FAILURE, "there are no flags for instances");
  check_application(info.applicationInfo);
  const std::set<std::string> asked = asked_extensions(info);
  Instance made;
  made.handle = std::bit_cast<XrInstance>(++runtime().instances_made);
  made.extensions = asked;
  runtime().instance = std::move(made);
  log_instance(info.applicationInfo, asked);
  place = runtime().instance->handle;
  return XR_SUCCESS;
}

XrResult destroy_instance(XrInstance instance) {
  instance_of(instance);
  if (runtime().session) {
    forget_session();
  }
  runtime().actions.clear();
  runtime().action_sets.clear();
  runtime().instance.reset();
  runtime().log.write({{"kind", "end"}});
  return XR_SUCCESS;
}

XrResult get_instance_properties(XrInstance instance, XrInstanceProperties* properties) {
  instance_of(instance);
  XrInstanceProperties& place =
      checked(properties, XR_TYPE_INSTANCE_PROPERTIES, "the place for the properties");
  place.runtimeVersion = XR_MAKE_VERSION(1, 0, 0);
  put_text("Foveola's test runtime", place.runtimeName);
  return XR_SUCCESS;
}

XrResult poll_event(XrInstance instance, XrEventDataBuffer* event) {
  std::deque<XrEventDataBuffer>& events = instance_of(instance).events;
  // Its type says what was in it last, since buffers are used again, so that many applications set
  // it anew and the strictest reading of the specification asks for it.
  XrEventDataBuffer& place = checked(event, XR_TYPE_EVENT_DATA_BUFFER, "the place for the event");
  if (events.empty()) {
    return XR_EVENT_UNAVAILABLE;
  }
  place = events.front();
  events.pop_front();
  return XR_SUCCESS;
}

XrResult result_to_string(XrInstance instance, XrResult value, char* buffer) {
  instance_of(instance);
  const std::string unknown =
      (value < 0 ? "XR_UNKNOWN_FAILURE_" : "XR_UNKNOWN_SUCCESS_") + std::to_string(value);
  put_text(name_of(value).value_or(unknown),
           reinterpret_cast<char(&)[XR_MAX_RESULT_STRING_SIZE]>(place_for(buffer, "the buffer")));
  return XR_SUCCESS;
}

XrResult structure_type_to_string(XrInstance instance, XrStructureType value, char* buffer) {
  instance_of(instance);
  const std::string unknown = "XR_UNKNOWN_STRUCTURE_TYPE_" + std::to_string(value);
  put_text(name_of(value).value_or(unknown),
           reinterpret_cast<char(&)[XR_MAX_STRUCTURE_NAME_SIZE]>(place_for(buffer, "the buffer")));
  return XR_SUCCESS;
}

XrResult string_to_path(XrInstance instance, const char* text, XrPath* path) {
  instance_of(instance);
  XrPath& place = place_for(path, "the place for the path");
  require(text != nullptr, XR_ERROR_VALIDATION_FAILURE, "the path is a null pointer");
  if (!is_well_formed(text)) {
    throw Refusal(XR_ERROR_PATH_FORMAT_INVALID, fmt::format("'{}' is no path", text));
  }
  place = path_of(text);
  return XR_SUCCESS;
}

XrResult path_to_string(XrInstance instance, XrPath path, std::uint32_t capacity,
                        std::uint32_t* count, char* buffer) {
  instance_of(instance);
  give_text(text_of(path), capacity, count, buffer);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
