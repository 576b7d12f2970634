// OpenXR's functions, found at run time: the program starts, and does all else, without its loader.
#pragma once

#include <memory>
#include <string>

#include <openxr/openxr.h>

namespace foveola {

/// Calls `DO` with the name of each function that is used, without its "xr".
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

/// No other than that of what it is in.
inline constexpr XrPosef same_pose = {{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};

/// Writes a text into a field of one of OpenXR's structures, cut to what it holds.
template <std::size_t size>
void put_text(const std::string& text, char (&field)[size]) {
  field[text.copy(field, size - 1)] = '\0';
}

/// The loader writes nothing of its own, where the environment does not ask for it: what goes wrong
/// is told by Error. To be called before there are threads.
void silence_xr_loader();

/// The loader's library, for as long as it lives.
class XrLoader {
 public:
  /// Throws Error if it is not installed.
  XrLoader();

  /// Empty if there is none. instance: null for those that need none.
  PFN_xrVoidFunction find(XrInstance instance, const char* name) const;
  /// Throws Error if one is missing.
  XrFunctions functions_of(XrInstance instance) const;

 private:
  struct Close {
    void operator()(void* library) const;
  };

  std::unique_ptr<void, Close> library_;
  PFN_xrGetInstanceProcAddr find_ = nullptr;
};

}  // namespace foveola
