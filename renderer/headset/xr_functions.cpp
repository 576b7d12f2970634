#include "renderer/headset/xr_functions.h"

#include <cstdlib>

#include <dlfcn.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr const char* loader_name = "libopenxr_loader.so.1";

}  // namespace

void silence_xr_loader() { ::setenv("XR_LOADER_DEBUG", "none", 0); }

void XrLoader::Close::operator()(void* library) const { ::dlclose(library); }

XrLoader::XrLoader() : library_(::dlopen(loader_name, RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) {
    throw Error("headset", std::string("OpenXR's loader is not there: ") + ::dlerror(),
                "install libopenxr-loader1, and the runtime of the headset");
  }
  find_ =
      reinterpret_cast<PFN_xrGetInstanceProcAddr>(::dlsym(library_.get(), "xrGetInstanceProcAddr"));
  if (find_ == nullptr) {
    throw Error("headset", std::string(loader_name) + " is not a loader of OpenXR",
                "install libopenxr-loader1");
  }
}

PFN_xrVoidFunction XrLoader::find(XrInstance instance, const char* name) const {
  PFN_xrVoidFunction found = nullptr;
  return XR_SUCCEEDED(find_(instance, name, &found)) ? found : nullptr;
}

XrFunctions XrLoader::functions_of(XrInstance instance) const {
  const auto required = [&](const char* name) {
    const PFN_xrVoidFunction found = find(instance, name);
    if (found == nullptr) {
      throw Error("headset", std::string("OpenXR's runtime has no function ") + name,
                  "update the headset's runtime");
    }
    return found;
  };
  XrFunctions functions;
#define FOVEOLA_XR_FIND(name) functions.name = reinterpret_cast<PFN_xr##name>(required("xr" #name));
  FOVEOLA_FOR_EACH_XR_FUNCTION(FOVEOLA_XR_FIND)
#undef FOVEOLA_XR_FIND
  return functions;
}

}  // namespace foveola
