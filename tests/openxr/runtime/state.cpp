#include "tests/openxr/runtime/state.h"

#include <cstdlib>

namespace foveola::test::openxr {
namespace {

std::filesystem::path path_in_environment(const char* variable) {
  const char* const value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

}  // namespace

Runtime& runtime() {
  static Runtime only;
  return only;
}

void read_environment() {
  runtime().log.open(path_in_environment("FOVEOLA_OPENXR_LOG"));
  const std::filesystem::path file = path_in_environment("FOVEOLA_OPENXR_SCRIPT");
  if (file != runtime().script_file) {
    runtime().script_file = file;
    runtime().sessions_of_script = 0;
  }
  runtime().script = read_script(file);
}

Instance& instance_of(XrInstance handle) {
  std::optional<Instance>& instance = runtime().instance;
  require(instance && instance->handle == handle, XR_ERROR_HANDLE_INVALID,
          "there is no such instance");
  return *instance;
}

Session& session_of(XrSession handle) {
  std::optional<Session>& session = runtime().session;
  require(session && session->handle == handle, XR_ERROR_HANDLE_INVALID,
          "there is no such session");
  return *session;
}

Session& running_session_of(XrSession handle) {
  Session& session = session_of(handle);
  require(session.is_running, XR_ERROR_SESSION_NOT_RUNNING,
          "the session was not begun, or has ended");
  return session;
}

Session& current_session() {
  require(runtime().session.has_value(), XR_ERROR_HANDLE_INVALID, "there is no session");
  return *runtime().session;
}

const std::string& text_of(XrPath path) {
  require(runtime().instance.has_value(), XR_ERROR_HANDLE_INVALID, "there is no instance");
  const std::vector<std::string>& paths = runtime().instance->paths;
  require(path != XR_NULL_PATH && path <= paths.size(), XR_ERROR_PATH_INVALID,
          "the path is not one that xrStringToPath gave");
  return paths[path - 1];
}

XrPath path_of(const std::string& text) {
  std::vector<std::string>& paths = runtime().instance->paths;
  const auto found = std::find(paths.begin(), paths.end(), text);
  if (found != paths.end()) {
    return static_cast<XrPath>(found - paths.begin()) + 1;
  }
  paths.push_back(text);
  return paths.size();
}

bool is_enabled(const char* extension) {
  return runtime().instance && runtime().instance->extensions.contains(extension);
}

}  // namespace foveola::test::openxr
