// Loads OpenXR's functions at run time: the program starts and works without OpenXR's loader.
#pragma once

#include <memory>
#include <string>

#include <openxr/openxr.h>

namespace foveola {

/// Calls `DO` with the name of each used function, without its "xr".
#define FOVEOLA_FOR_EACH_XR_FUNCTION(DO) \
  DO(AcquireSwapchainImage)              \
  DO(AttachSessionActionSets)            \
  DO(BeginFrame)                         \
  DO(BeginSession)                       \
  DO(CreateAction)                       \
  DO(CreateActionSet)                    \
  DO(CreateActionSpace)                  \
  DO(CreateReferenceSpace)               \
  DO(CreateSession)                      \
  DO(CreateSwapchain)                    \
  DO(DestroyInstance)                    \
  DO(DestroySession)                     \
  DO(EndFrame)                           \
  DO(EndSession)                         \
  DO(EnumerateSwapchainFormats)          \
  DO(EnumerateSwapchainImages)           \
  DO(EnumerateViewConfigurationViews)    \
  DO(GetActionStateBoolean)              \
  DO(GetActionStatePose)                 \
  DO(GetActionStateVector2f)             \
  DO(GetInstanceProperties)              \
  DO(GetSystem)                          \
  DO(GetSystemProperties)                \
  DO(LocateSpace)                        \
  DO(LocateViews)                        \
  DO(PollEvent)                          \
  DO(ReleaseSwapchainImage)              \
  DO(ResultToString)                     \
  DO(StringToPath)                       \
  DO(SuggestInteractionProfileBindings)  \
  DO(SyncActions)                        \
  DO(WaitFrame)                          \
  DO(WaitSwapchainImage)

/// An instance's functions, by their names without "xr".
struct XrFunctions {
#define FOVEOLA_XR_MEMBER(name) PFN_xr##name name = nullptr;
  FOVEOLA_FOR_EACH_XR_FUNCTION(FOVEOLA_XR_MEMBER)
#undef FOVEOLA_XR_MEMBER
};

/// The identity pose.
inline constexpr XrPosef same_pose = {{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

/// Writes a text into a field of one of OpenXR's structures, truncated to its size.
template <std::size_t size>
void put_text(const std::string& text, char (&field)[size]) {
  field[text.copy(field, size - 1)] = '\0';
}

/// Silences the loader's own output, unless the environment asks for it, since faults are reported
/// by Error. To be called before other threads start.
void silence_xr_loader();

/// The loader's library, loaded while this object lives.
class XrLoader {
 public:
  /// Throws Error if it is not installed.
  XrLoader();

  /// nullptr if there is none. instance: null for functions without one.
  PFN_xrVoidFunction find(XrInstance instance, const char* name) const;
  /// Throws Error if a function is missing.
  XrFunctions functions_of(XrInstance instance) const;

 private:
  struct Close {
    void operator()(void* library) const;
  };

  std::unique_ptr<void, Close> library_;
  PFN_xrGetInstanceProcAddr find_ = nullptr;
};

}  // namespace foveola
