// Functions of OpenXR that this runtime has: those that Foveola calls. The loader's validation
// layer checks handles, types of structures and null pointers; these functions check what it does
// not see, and throw a Refusal for it.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// Calls `DO` with each function's name without its "xr".
#define FOVEOLA_FOR_EACH_CALL(DO)          \
  DO(EnumerateInstanceExtensionProperties) \
  DO(CreateInstance)                       \
  DO(DestroyInstance)                      \
  DO(GetInstanceProperties)                \
  DO(PollEvent)                            \
  DO(ResultToString)                       \
  DO(StringToPath)                         \
  DO(GetSystem)                            \
  DO(GetSystemProperties)                  \
  DO(EnumerateViewConfigurationViews)      \
  DO(GetOpenGLGraphicsRequirementsKHR)     \
  DO(ConvertTimespecTimeToTimeKHR)         \
  DO(ConvertTimeToTimespecTimeKHR)         \
  DO(GetVisibilityMaskKHR)                 \
  DO(CreateSession)                        \
  DO(DestroySession)                       \
  DO(BeginSession)                         \
  DO(EndSession)                           \
  DO(CreateReferenceSpace)                 \
  DO(CreateActionSpace)                    \
  DO(LocateSpace)                          \
  DO(LocateViews)                          \
  DO(EnumerateSwapchainFormats)            \
  DO(CreateSwapchain)                      \
  DO(EnumerateSwapchainImages)             \
  DO(AcquireSwapchainImage)                \
  DO(WaitSwapchainImage)                   \
  DO(ReleaseSwapchainImage)                \
  DO(WaitFrame)                            \
  DO(BeginFrame)                           \
  DO(EndFrame)                             \
  DO(CreateActionSet)                      \
  DO(CreateAction)                         \
  DO(SuggestInteractionProfileBindings)    \
  DO(AttachSessionActionSets)              \
  DO(SyncActions)                          \
  DO(GetActionStateBoolean)                \
  DO(GetActionStateVector2f)               \
  DO(GetActionStatePose)

#define FOVEOLA_DECLARE_CALL(name) std::remove_pointer_t<PFN_xr##name> name;
FOVEOLA_FOR_EACH_CALL(FOVEOLA_DECLARE_CALL)
#undef FOVEOLA_DECLARE_CALL

/// Ends a call with its result, and tells the test why.
class Refusal : public std::runtime_error {
 public:
  Refusal(XrResult result, const std::string& why) : std::runtime_error(why), result_(result) {}
  XrResult result() const { return result_; }

 private:
  XrResult result_;
};

inline void require(bool holds, XrResult otherwise, const std::string& why) {
  if (!holds) {
    throw Refusal(otherwise, why);
  }
}

/// The structure of this type that is chained to another, or null.
template <typename Structure>
Structure* chained(const void* next, XrStructureType type) {
  for (auto* link = static_cast<const XrBaseInStructure*>(next); link != nullptr;
       link = link->next) {
    if (link->type == type) {
      return reinterpret_cast<Structure*>(const_cast<XrBaseInStructure*>(link));
    }
  }
  return nullptr;
}

/// Answers a question that an application asks twice: first for the number of items, then for them.
template <typename Item>
void give_items(const std::vector<Item>& items, std::uint32_t capacity, std::uint32_t* count,
                Item* out) {
  *count = static_cast<std::uint32_t>(items.size());
  if (capacity > 0) {
    require(capacity >= items.size(), XR_ERROR_SIZE_INSUFFICIENT, "the array is too short");
    std::ranges::copy(items, out);
  }
}

/// Writes a text into an array of a structure, cut off where it does not fit.
template <std::size_t size>
void put_text(const std::string& text, char (&out)[size]) {
  out[text.copy(out, size - 1)] = '\0';
}

}  // namespace foveola::test::openxr
