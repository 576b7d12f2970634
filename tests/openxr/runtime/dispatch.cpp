// How the loader gets at the runtime's functions.
#include <functional>
#include <iostream>
#include <string_view>

#include <fmt/format.h>

#include "tests/openxr/runtime/negotiation.h"
#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

/// The script's result in place of the call's.
std::optional<XrResult> scripted_failure(std::string_view function) {
  const std::optional<Session>& session = runtime().session;
  const double time_s = session && !session->frames.empty() ? session->frames.back().time_s : -1.0;
  for (ScriptedFailure& failure : runtime().script.failures) {
    if (failure.function == function && failure.times > 0 && time_s >= failure.time_s) {
      --failure.times;
      return failure.result;
    }
  }
  return std::nullopt;
}

XrResult refuse(const char* function, XrResult result, const std::string& why) {
  const std::string line = fmt::format("{}: {}: {}", function, result_name(result), why);
  std::cerr << line + "\n";
  write_log({{"kind", "refusal"}, {"why", line}});
  return result;
}

XrResult answer(const char* function, const std::function<XrResult()>& call) {
  const std::scoped_lock lock(runtime().mutex);
  try {
    const std::optional<XrResult> failure = scripted_failure(function);
    return failure ? *failure : call();
  } catch (const Refusal& refusal) {
    return refuse(function, refusal.result(), refusal.what());
  } catch (const std::exception& error) {
    return refuse(function, XR_ERROR_RUNTIME_FAILURE, error.what());
  }
}

/// The function that the application calls for `function`.
template <auto function>
struct Answered;

template <typename... Arguments, XrResult (*function)(Arguments...)>
struct Answered<function> {
  static inline const char* name = nullptr;
  static XrResult XRAPI_CALL call(Arguments... arguments) {
    return answer(name, [&] { return function(arguments...); });
  }
};

template <auto function>
PFN_xrVoidFunction answered(const char* name) {
  Answered<function>::name = name;
  return reinterpret_cast<PFN_xrVoidFunction>(&Answered<function>::call);
}

/// The loader asks for every function that it knows.
XrResult XRAPI_CALL get_instance_proc_addr(XrInstance /*instance*/, const char* name,
                                           PFN_xrVoidFunction* function) {
#define FOVEOLA_ENTRY(name) {"xr" #name, answered<name>("xr" #name)},
  static const std::map<std::string_view, PFN_xrVoidFunction> all = {
      FOVEOLA_FOR_EACH_CALL(FOVEOLA_ENTRY){
          "xrGetInstanceProcAddr", reinterpret_cast<PFN_xrVoidFunction>(&get_instance_proc_addr)}};
#undef FOVEOLA_ENTRY
  const auto found = all.find(name);
  *function = found == all.end() ? nullptr : found->second;
  return found == all.end() ? XR_ERROR_FUNCTION_UNSUPPORTED : XR_SUCCESS;
}

}  // namespace
}  // namespace foveola::test::openxr

extern "C" __attribute__((visibility("default"))) XrResult XRAPI_CALL
xrNegotiateLoaderRuntimeInterface(const foveola::test::openxr::LoaderInfo* loader_info,
                                  foveola::test::openxr::RuntimeRequest* request) {
  using namespace foveola::test::openxr;
  if (loader_info->min_interface_version > runtime_interface_version ||
      loader_info->max_interface_version < runtime_interface_version) {
    return XR_ERROR_INITIALIZATION_FAILED;
  }
  request->runtime_interface_version = runtime_interface_version;
  request->runtime_api_version = XR_MAKE_VERSION(1, 0, 20);
  request->get_instance_proc_addr = get_instance_proc_addr;
  return XR_SUCCESS;
}
